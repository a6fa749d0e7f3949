/// @file
/// PixelSize: the size of an image or of a cell.
#pragma once

namespace rtb {

/// Width and height in pixels.
struct PixelSize {
  int width = 0;
  int height = 0;
  bool operator==(const PixelSize&) const = default;
};

}  // namespace rtb
