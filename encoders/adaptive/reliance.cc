#include "encoders/adaptive/reliance.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "core/base/parallel.h"
#include "encoders/adaptive/wide_mean.h"

namespace rtb {
namespace {

constexpr int kGrain = 16;

/// Keeps weights finite, as in BlendNearest.
constexpr float kWithinPixel = 0.25f;

/// What is believed before there is evidence: 1, as if these much squared
/// difference had been foretold. A contrast of 0.04 over 3 samples' areas.
constexpr double kPriorSquares = 0.02;

/// Sums of a regression through the origin, y = slope x.
struct Regression {
  double xy = 0;
  double xx = 0;

  Regression& operator+=(const Regression& other) {
    xy += other.xy;
    xx += other.xx;
    return *this;
  }
};

/// What the other samples say of the place of one of them.
class LeftOut {
 public:
  /// @param near at least two samples.
  LeftOut(const NearSamples& near, std::size_t which) {
    std::array<std::size_t, kNearest> index{};
    distance2_.fill(std::numeric_limits<float>::max());
    float sum = 0;
    for (std::size_t n = 0; n < near.size(); ++n) {
      if (n == which) continue;
      const float dx = near.x[n] - near.x[which];
      const float dy = near.y[n] - near.y[which];
      const float weight = WideWeight(dx, dy);
      wide_ += near.encoded[n] * weight;
      sum += weight;
      Keep(dx * dx + dy * dy + kWithinPixel, n, index);
    }
    wide_ /= sum;
    sum = 0;
    for (std::size_t k = 0; k < std::min(kNearest, near.size() - 1); ++k) {
      const float weight = 1 / (distance2_[k] * distance2_[k]);
      nearest_ += near.encoded[index[k]] * weight;
      sum += weight;
    }
    nearest_ /= sum;
  }

  const Rgb& wide() const { return wide_; }
  const Rgb& nearest() const { return nearest_; }
  /// Squared, to the nearest other sample.
  float distance2() const { return distance2_[0]; }

 private:
  /// Sorts a sample in where it is among the nearest.
  void Keep(float distance2, std::size_t sample,
            std::array<std::size_t, kNearest>& index) {
    if (distance2 >= distance2_.back()) return;
    for (std::size_t k = 0; k < kNearest; ++k) {
      if (distance2 >= distance2_[k]) continue;
      std::swap(distance2, distance2_[k]);
      std::swap(sample, index[k]);
    }
  }

  std::array<float, kNearest> distance2_;
  Rgb wide_{0};
  Rgb nearest_{0};
};

/// How one cell's own samples follow from the others. A sample counts as the
/// area that it stands for, or edges, where samples crowd, would speak for all.
Regression RegressionOf(const NearSamples& near, float cell_width) {
  Regression sums;
  if (near.size() < 2 || near.Alike()) return sums;
  for (std::size_t n = 0; n < near.size(); ++n) {
    const bool inside = near.x[n] >= 0 && near.x[n] < cell_width &&
                        near.y[n] >= 0 && near.y[n] < kCellHeight;
    if (!inside) continue;
    const LeftOut others(near, n);
    const Rgb x = others.nearest() - others.wide();
    const Rgb y = near.encoded[n] - others.wide();
    sums.xy += static_cast<double>(others.distance2() * x.dot(y));
    sums.xx += static_cast<double>(others.distance2() * x.dot(x));
  }
  return sums;
}

/// The sums of a cell and its eight neighbors.
Regression Pooled(const std::vector<Regression>& sums, GridSize grid,
                  int cell) {
  const int x = cell % grid.columns;
  const int y = cell / grid.columns;
  Regression pooled;
  for (int j = std::max(0, y - 1); j <= std::min(grid.rows - 1, y + 1); ++j) {
    for (int i = std::max(0, x - 1); i <= std::min(grid.columns - 1, x + 1);
         ++i) {
      pooled += sums[static_cast<std::size_t>(j * grid.columns + i)];
    }
  }
  return pooled;
}

/// From samples to places. Places lie nearer to samples than these to each
/// other, and are foretold better. The fourth power is what references showed:
/// slopes of 0.1, 0.3, 0.5 and 0.7 stand for 0.3, 0.6, 0.8 and 0.9 and more.
float ForPlaces(double slope) {
  const double miss = 1 - std::clamp(slope, 0.0, 1.0);
  return static_cast<float>(1 - miss * miss * miss * miss);
}

}  // namespace

std::vector<float> Reliances(const ByCell& samples, int threads) {
  const GridSize grid = samples.grid();
  const auto cells = static_cast<std::size_t>(grid.cells());
  std::vector<Regression> sums(cells);
  ParallelFor(grid.cells(), kGrain, threads, [&](int begin, int end) {
    NearSamples near;
    for (int cell = begin; cell < end; ++cell) {
      samples.Gather(cell, near);
      sums[static_cast<std::size_t>(cell)] =
          RegressionOf(near, samples.cell_width());
    }
  });
  std::vector<float> reliances(cells);
  for (std::size_t cell = 0; cell < cells; ++cell) {
    const Regression pooled = Pooled(sums, grid, static_cast<int>(cell));
    reliances[cell] =
        ForPlaces((pooled.xy + kPriorSquares) / (pooled.xx + kPriorSquares));
  }
  return reliances;
}

}  // namespace rtb
