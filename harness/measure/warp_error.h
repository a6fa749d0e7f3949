/// @file
/// How much pictures change along the movement of what they show.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "core/image/image.h"
#include "core/render/motion.h"

namespace rtb {

/// Gathers, over steps of a sequence, the mean absolute difference of each
/// pixel and the place where its surface was one frame before, of the pixels
/// whose surface was visible there. After Lai et al., "Learning Blind Video
/// Temporal Consistency", ECCV 2018, section 5, with the renderer's motion in
/// place of optical flow, and absolute differences like those of `tde`.
class WarpError {
 public:
  /// Adds one step. Places between pixel centers are interpolated bilinearly.
  /// @param now,before sRGB-encoded values, of the size that was traced.
  void Add(const Image& now, const Image& before,
           std::span<const PixelMotion> motions);

  /// Mean over pixels and channels; none without a visible pixel.
  std::optional<double> Mean() const;

 private:
  double sum_ = 0;
  std::size_t pixels_ = 0;
};

/// The image at a place in pixels from the top left corner, pixel centers at
/// halves: bilinear, borders replicated.
V3d Interpolate(const Image& image, const V2d& place);

}  // namespace rtb
