/// @file
/// MeanOfRays: what the rays of one sample bring together, host and device.
#pragma once

#include <limits>

#include "core/base/host_device.h"
#include "core/math/vec.h"

namespace rtb {

/// Radiance as it may leave the renderer: no NaN, infinity or negative value.
RTB_HD inline float Sanitized(double value) {
  constexpr double kLargest = std::numeric_limits<float>::max();
  if (!(value > 0)) return 0;
  return static_cast<float>(value < kLargest ? value : kLargest);
}

/// Gathers the rays of one sample.
class MeanOfRays {
 public:
  RTB_HD_CALLED void Add(const V3d& radiance) {
    ++count_;
    sum_ += radiance;
    squares_ += radiance * radiance;
  }

  RTB_HD Rgb Mean() const {
    const V3d mean = sum_ / count_;
    return {Sanitized(mean.x), Sanitized(mean.y), Sanitized(mean.z)};
  }

  /// Of the mean, as if the rays were independent; mean over the channels. 0
  /// for one ray.
  RTB_HD float Variance() const {
    if (count_ < 2) return 0;
    const V3d spread = squares_ - sum_ * sum_ / count_;
    return Sanitized((spread.x + spread.y + spread.z) /
                     (3.0 * count_ * (count_ - 1)));
  }

 private:
  int count_ = 0;
  V3d sum_{0};
  V3d squares_{0};
};

}  // namespace rtb
