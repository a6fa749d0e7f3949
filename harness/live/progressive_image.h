/// @file
/// ProgressiveImage: a picture that grows better with every step.
#pragma once

#include <memory>
#include <vector>

#include "core/base/result.h"
#include "core/image/image.h"
#include "harness/live/live_view.h"
#include "harness/prepared_scene.h"

namespace rtb {

/// 8 x 16 pixels a cell of a view, rendered with more and more rays. Encoders
/// do not matter.
class ProgressiveImage {
 public:
  static constexpr int kCellWidth = 8;
  static constexpr int kCellHeight = 16;

  /// Begins anew where the samples of `view` are others.
  Status Aim(const LiveView& view);

  /// Adds `rays` rays to every pixel, on one thread.
  Status Step(int rays);

  /// Rays of each pixel so far.
  int rays() const { return rays_; }

  /// sRGB-encoded and rounded to 8 bits, as references are.
  Image Displayed() const;

 private:
  LiveView view_;
  PreparedScene scene_;
  std::vector<Rgb> sums_;  ///< Cell by cell.
  int rays_ = 0;
  bool aimed_ = false;
};

}  // namespace rtb
