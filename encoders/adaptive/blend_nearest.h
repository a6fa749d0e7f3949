/// @file
/// Places as means of the samples nearest to them: the inner loop of Rebuild,
/// by vectors. Highway chooses the instruction set at run time; all give the
/// same bits.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/math/vec.h"

namespace rtb {

/// Samples that a place is made of.
inline constexpr std::size_t kNearest = 3;

/// Samples that BlendNearest can tell apart.
inline constexpr std::size_t kMostNear = 1023;

/// Samples around a cell, by value for value.
struct NearSamples {
  std::vector<float> x, y;  ///< From the cell's top left; see kCellHeight.
  std::vector<Rgb> encoded;
  std::vector<Rgb> linear;

  std::size_t size() const { return x.size(); }
  /// Whether they differ by so little that nothing of it is seen.
  bool Alike() const;
  /// Whether some of the light is white, or was more than that.
  bool Overexposed() const;
  void Clear();
  void Add(const V2f& at, const Rgb& encoded_color, const Rgb& linear_color);
};

/// The places in one cell, as many as a multiple of `kRoom`.
struct BlendPlaces {
  /// Lanes of any instruction set.
  static constexpr std::size_t kRoom = 16;

  /// The centers of width x height sub-pixels; the last one stands for what is
  /// missing to a full vector.
  BlendPlaces(int width, int height, float cell_width);

  std::vector<float> x, y;
};

/// What BlendNearest makes of each place.
struct BlendedPlaces {
  explicit BlendedPlaces(const BlendPlaces& places);

  std::vector<Rgb> encoded;  ///< Mean of encoded values.
  std::vector<Rgb> linear;   ///< Mean of linear light.
  std::vector<float> share;  ///< How far the linear one counts, in 0..1.
};

/// Means of the kNearest samples nearest to each place, weighted by the inverse
/// of the fourth power of the distance (Shepard, "A Two-Dimensional
/// Interpolation Function for Irregularly-Spaced Data", ACM National Conference
/// 1968). Of equal distances the earlier sample is nearer.
/// @param near 1 to kMostNear samples.
void BlendNearest(const NearSamples& near, const BlendPlaces& places,
                  BlendedPlaces& out);

}  // namespace rtb
