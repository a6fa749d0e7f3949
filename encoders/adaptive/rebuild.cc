#include "encoders/adaptive/rebuild.h"

#include <algorithm>

#include "core/base/parallel.h"
#include "core/color/srgb.h"
#include "encoders/adaptive/blend_nearest.h"

namespace rtb {
namespace {

constexpr int kGrain = 16;

/// Samples farther than this from a cell do not count in it.
constexpr float kMargin = 8;

/// The samples sorted by cell, in their order.
class ByCell {
 public:
  explicit ByCell(const SeenSamples& samples) : grid_(samples.grid()) {
    begin_.resize(static_cast<std::size_t>(grid_.cells()) + 1);
    for (int c = 0; c < grid_.cells(); ++c) {
      const auto at = static_cast<std::size_t>(c);
      begin_[at + 1] = begin_[at] + static_cast<std::size_t>(samples.count(c));
    }
    sorted_.resize(begin_.back());
    std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
    for (const SeenSample& sample : samples.all()) {
      sorted_[next[static_cast<std::size_t>(sample.cell)]++] = &sample;
    }
  }

  /// Those in the cell and up to kMargin around it.
  void Gather(int cell, float cell_width, NearSamples& near) const {
    near.Clear();
    const int column = cell % grid_.columns;
    const int row = cell / grid_.columns;
    for (int j = std::max(0, row - 1); j <= std::min(grid_.rows - 1, row + 1);
         ++j) {
      for (int i = std::max(0, column - 1);
           i <= std::min(grid_.columns - 1, column + 1); ++i) {
        const auto c = static_cast<std::size_t>(j * grid_.columns + i);
        for (std::size_t s = begin_[c]; s < begin_[c + 1]; ++s) {
          const SeenSample& sample = *sorted_[s];
          const float x =
              (static_cast<float>(i - column) + sample.position.x) * cell_width;
          const float y =
              (static_cast<float>(j - row) + sample.position.y) * kCellHeight;
          const float ox = std::max({-x, x - cell_width, 0.0f});
          const float oy = std::max({-y, y - kCellHeight, 0.0f});
          if (ox * ox + oy * oy > kMargin * kMargin) continue;
          if (near.size() == kMostNear) return;
          near.Add({x, y}, sample.encoded, sample.linear);
        }
      }
    }
  }

 private:
  GridSize grid_;
  std::vector<std::size_t> begin_;
  std::vector<const SeenSample*> sorted_;
};

/// Rebuilds cells, one at a time.
class CellBuilder {
 public:
  CellBuilder(const ByCell& samples, int width, int height, float cell_width)
      : samples_(samples),
        cell_width_(cell_width),
        places_(width, height, cell_width),
        blended_(places_) {}

  void Build(int cell, std::span<Rgb> out) {
    samples_.Gather(cell, cell_width_, near_);
    BlendNearest(near_, places_, blended_);
    SrgbEncode(blended_.linear, blended_.linear);
    for (std::size_t i = 0; i < out.size(); ++i) {
      const Rgb& far = blended_.encoded[i];
      out[i] = far + (blended_.linear[i] - far) * blended_.share[i];
    }
  }

 private:
  const ByCell& samples_;
  float cell_width_;
  BlendPlaces places_;
  NearSamples near_;
  BlendedPlaces blended_;
};

}  // namespace

RebuiltRaster Rebuild(const SeenSamples& samples, int width, int height,
                      double cell_aspect, int threads) {
  const ByCell by_cell(samples);
  const int cells = samples.grid().cells();
  const auto size =
      static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  RebuiltRaster raster{width, height, {}};
  raster.encoded.resize(static_cast<std::size_t>(cells) * size, Rgb(0));
  ParallelFor(cells, kGrain, threads, [&](int begin, int end) {
    CellBuilder builder(by_cell, width, height, CellWidth(cell_aspect));
    for (int cell = begin; cell < end; ++cell) {
      builder.Build(cell,
                    std::span(raster.encoded)
                        .subspan(static_cast<std::size_t>(cell) * size, size));
    }
  });
  return raster;
}

}  // namespace rtb
