/// @file
/// Paths: the states of many paths, to be extended together.
#pragma once

#include <cstdint>

namespace rtb {

/// Arrays of one number for each path. The first `count` of them go on; when
/// all have ended, `result` has their radiances.
struct Paths {
  /// So many that a vector is seldom part empty, so few that they stay in the
  /// first-level cache.
  static constexpr int kMost = 256;
  /// Vectors may write past the last path.
  static constexpr int kRoom = kMost + 16;
  template <class T>
  using Row = T[kRoom];
  using Rows = Row<float>[3];

  int count = 0;
  // Where in the picture each begins: in cells, to the right and downwards.
  alignas(64) Row<double> x;
  alignas(64) Row<double> y;
  // Of each that goes on.
  alignas(64) Rows origin;
  alignas(64) Rows direction;
  alignas(64) Row<std::uint32_t> pattern;  ///< EyeSample's.
  alignas(64) Row<std::uint32_t> index;    ///< EyeSample's.
  alignas(64) Rows throughput;
  alignas(64) Rows radiance;
  alignas(64) Row<float> pdf;  ///< Of the direction; 0: it was the only one.
  alignas(64) Row<std::int32_t> number;  ///< Its place in `result`.

  alignas(64) Rows result;
};

}  // namespace rtb
