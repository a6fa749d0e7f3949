/// @file
/// Image: the raster type of the program.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/base/check.h"
#include "core/math/vec.h"

namespace rtb {

/// A raster of float RGB pixels, row by row from the top left. Whether the
/// values are scene-linear or sRGB-encoded is said where an Image is passed.
class Image {
 public:
  Image() = default;
  /// A black image of width x height pixels.
  Image(int width, int height)
      : width_(width),
        height_(height),
        pixels_(
            static_cast<std::size_t>(width) * static_cast<std::size_t>(height),
            Rgb(0)) {
    RTB_CHECK_GE(width, 0);
    RTB_CHECK_GE(height, 0);
  }

  int width() const { return width_; }
  int height() const { return height_; }
  bool empty() const { return pixels_.empty(); }

  Rgb& at(int x, int y) { return pixels_[Index(x, y)]; }
  const Rgb& at(int x, int y) const { return pixels_[Index(x, y)]; }

  /// All pixels, row by row.
  std::span<Rgb> pixels() { return pixels_; }
  std::span<const Rgb> pixels() const { return pixels_; }

 private:
  std::size_t Index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(x);
  }

  int width_ = 0;
  int height_ = 0;
  std::vector<Rgb> pixels_;
};

}  // namespace rtb
