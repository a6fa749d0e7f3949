#include "encoders/adaptive/rebuild.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

#include "core/base/parallel.h"
#include "core/color/srgb.h"

namespace rtb {
namespace {

constexpr int kGrain = 16;

/// Samples that a sub-pixel is made of.
constexpr std::size_t kNearest = 3;

/// Samples farther than this from a cell do not count in it.
constexpr float kMargin = 8;

/// Keeps weights finite: about the squared distance within a sub-pixel.
constexpr float kWithinPixel = 0.25f;

/// Samples nearer to each other than this tell how a sub-pixel is divided.
constexpr float kPixelReach = 1.5f;

/// A sample as a cell sees it.
struct Near {
  float x, y;  ///< From the cell's top left.
  Rgb encoded;
  Rgb linear;
};

/// A squared distance with an index in its lowest bits: a positive float, so
/// that comparing two of them compares the distances.
constexpr std::uint32_t kIndexBits = 1023;

float Key(float distance2, std::uint32_t index) {
  return std::bit_cast<float>(
      (std::bit_cast<std::uint32_t>(distance2 + kWithinPixel) & ~kIndexBits) |
      index);
}

std::uint32_t IndexOf(float key) {
  return std::bit_cast<std::uint32_t>(key) & kIndexBits;
}

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
  void Gather(int cell, float cell_width, std::vector<Near>& near) const {
    near.clear();
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
          near.push_back({x, y, sample.encoded, sample.linear});
        }
      }
    }
    if (near.size() > kIndexBits) near.resize(kIndexBits);
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
        width_(static_cast<std::size_t>(width)),
        height_(static_cast<std::size_t>(height)),
        cell_width_(cell_width),
        xs_(width_) {
    for (std::size_t i = 0; i < width_; ++i) {
      xs_[i] = (static_cast<float>(i) + 0.5f) * cell_width /
               static_cast<float>(width);
    }
    for (auto& keys : keys_) keys.resize(width_);
    mixed_.resize(width_ * height_);
    share_.resize(width_ * height_);
  }

  void Build(int cell, std::span<Rgb> out) {
    samples_.Gather(cell, cell_width_, near_);
    for (std::size_t j = 0; j < height_; ++j) {
      FindNearest((static_cast<float>(j) + 0.5f) * kCellHeight /
                  static_cast<float>(height_));
      for (std::size_t i = 0; i < width_; ++i) {
        const std::size_t at = j * width_ + i;
        Mix(i, out[at], mixed_[at], share_[at]);
      }
    }
    SrgbEncode(mixed_, mixed_);
    for (std::size_t i = 0; i < out.size(); ++i) {
      out[i] += (mixed_[i] - out[i]) * share_[i];
    }
  }

 private:
  /// The keys of the nearest samples of each sub-pixel of a row.
  void FindNearest(float y) {
    for (auto& keys : keys_) {
      std::ranges::fill(keys, std::numeric_limits<float>::max());
    }
    for (std::size_t n = 0; n < near_.size(); ++n) {
      const float dy = near_[n].y - y;
      const float dy2 = dy * dy;
      const float nx = near_[n].x;
      for (std::size_t i = 0; i < width_; ++i) {
        const float dx = nx - xs_[i];
        float key = Key(dx * dx + dy2, static_cast<std::uint32_t>(n));
        for (auto& keys : keys_) {
          const float low = keys[i] < key ? keys[i] : key;
          key = keys[i] < key ? key : keys[i];
          keys[i] = low;
        }
      }
    }
  }

  void Mix(std::size_t i, Rgb& encoded, Rgb& linear, float& share) const {
    float sum = 0;
    float far = 0;
    encoded = linear = Rgb(0);
    for (std::size_t k = 0; k < std::min(kNearest, near_.size()); ++k) {
      const float key = keys_[k][i];
      const Near& near = near_[IndexOf(key)];
      const float weight = 1 / (key * key);
      encoded += near.encoded * weight;
      linear += near.linear * weight;
      sum += weight;
      far = key;
    }
    encoded /= sum;
    linear /= sum;
    share = 1 / (1 + far / (kPixelReach * kPixelReach));
  }

  const ByCell& samples_;
  std::size_t width_;
  std::size_t height_;
  float cell_width_;
  std::vector<float> xs_;
  std::vector<Near> near_;
  std::array<std::vector<float>, kNearest> keys_;
  std::vector<Rgb> mixed_;
  std::vector<float> share_;
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
