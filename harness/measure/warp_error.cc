#include "harness/measure/warp_error.h"

#include <algorithm>
#include <cmath>

#include "core/base/check.h"

namespace rtb {
namespace {

/// The two pixels beside a coordinate, and the share of the second.
struct Neighbors {
  int first;
  int second;
  double share;
};

Neighbors NeighborsOf(double place, int count) {
  const double from_center = std::clamp(place - 0.5, 0.0, count - 1.0);
  const int first = static_cast<int>(std::floor(from_center));
  return {first, std::min(first + 1, count - 1), from_center - first};
}

double SumOfMagnitudes(const V3d& v) {
  return std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
}

}  // namespace

V3d Interpolate(const Image& image, const V2d& place) {
  const Neighbors x = NeighborsOf(place.x, image.width());
  const Neighbors y = NeighborsOf(place.y, image.height());
  const auto row = [&](int at) {
    return V3d(image.at(x.first, at)) * (1 - x.share) +
           V3d(image.at(x.second, at)) * x.share;
  };
  return row(y.first) * (1 - y.share) + row(y.second) * y.share;
}

void WarpError::Add(const Image& now, const Image& before,
                    std::span<const PixelMotion> motions) {
  RTB_CHECK_EQ(now.pixels().size(), motions.size());
  RTB_CHECK_EQ(before.pixels().size(), motions.size());
  for (std::size_t i = 0; i < motions.size(); ++i) {
    if (motions[i].sight != Sight::kVisible) continue;
    sum_ += SumOfMagnitudes(V3d(now.pixels()[i]) -
                            Interpolate(before, motions[i].place));
    ++pixels_;
  }
}

std::optional<double> WarpError::Mean() const {
  if (pixels_ == 0) return std::nullopt;
  return sum_ / (3 * static_cast<double>(pixels_));
}

}  // namespace rtb
