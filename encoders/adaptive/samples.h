/// @file
/// What `adaptive` has seen so far. FragmentSource -> SeenSamples -> VoronoiMap
/// (where to look next) and Rebuild (the raster to choose glyphs on).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/render/fragments.h"

namespace rtb {

/// Lengths in this folder count sixteenths of a cell's height as displayed: the
/// sub-pixels of the canonical 8 x 16 raster are 1 x 1.
inline constexpr float kCellHeight = 16;

/// A cell's width in that unit.
inline float CellWidth(double cell_aspect) {
  return kCellHeight * static_cast<float>(cell_aspect);
}

/// Light that counts at most. A pixel's is its mean before it is clipped: a
/// lamp makes pixels white of which it fills a part. The brightest ones would
/// reach too far from a sample to pixels that do not see them.
inline constexpr float kBrightest = 4;

/// One sample.
struct SeenSample {
  int cell = 0;
  V2f position{0, 0};  ///< Inside the cell, in [0, 1).
  Rgb linear{0};       ///< Clipped to [0, kBrightest], NaN is 0.
  Rgb encoded{0};      ///< Clipped to [0, 1], sRGB-encoded, NaN is 0.
};

/// The samples of a grid in the order they came.
class SeenSamples {
 public:
  explicit SeenSamples(GridSize grid)
      : grid_(grid),
        counts_(static_cast<std::size_t>(grid.cells())),
        variances_(counts_.size()) {}

  /// Makes room for so many samples.
  void Reserve(std::size_t count) { samples_.reserve(count); }

  /// Adds all answers to a plan.
  void Add(const SamplePlan& plan, const Fragments& fragments);

  GridSize grid() const { return grid_; }
  std::span<const SeenSample> all() const { return samples_; }
  /// Samples of one cell so far.
  int count(int cell) const { return counts_[static_cast<std::size_t>(cell)]; }
  /// Variance of the noise of one sample of a cell, as Fragments::variances:
  /// the mean of those known. 0 where none is.
  float variance(int cell) const {
    return count(cell) == 0 ? 0
                            : variances_[static_cast<std::size_t>(cell)] /
                                  static_cast<float>(count(cell));
  }

 private:
  void AddVariances(const SamplePlan& plan, std::span<const float> variances);

  GridSize grid_;
  std::vector<SeenSample> samples_;
  std::vector<int> counts_;
  std::vector<float> variances_;  ///< Summed, by cell.
};

}  // namespace rtb
