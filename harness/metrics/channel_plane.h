/// @file
/// ChannelPlane: one channel of a raster in double precision, what metrics
/// compute on.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace rtb {

/// width x height doubles, row by row from the top left.
class ChannelPlane {
 public:
  ChannelPlane() = default;
  ChannelPlane(int width, int height)
      : width_(width),
        height_(height),
        values_(static_cast<std::size_t>(width) *
                static_cast<std::size_t>(height)) {}

  int width() const { return width_; }
  int height() const { return height_; }

  /// The `width` values of a row.
  double* row(int y) { return values_.data() + Offset(y); }
  const double* row(int y) const { return values_.data() + Offset(y); }

  std::span<const double> values() const { return values_; }

 private:
  std::size_t Offset(int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_);
  }

  int width_ = 0;
  int height_ = 0;
  std::vector<double> values_;
};

/// Three channels of one size.
using ColorPlanes = std::array<ChannelPlane, 3>;

}  // namespace rtb
