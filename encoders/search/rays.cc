#include "encoders/search/rays.h"

#include "core/math/random.h"

namespace rtb {
V2f StripPosition(SearchDirection direction, int strips, int cell, int strip,
                  std::uint64_t seed) {
  const bool vertical = direction == SearchDirection::kVertical;
  const auto ray =
      static_cast<std::uint32_t>(vertical ? strip : strips + strip);
  const float along =
      UnitFloat(RandomBits(static_cast<std::uint32_t>(cell), ray, 0, seed));
  const float center =
      (static_cast<float>(strip) + 0.5f) / static_cast<float>(strips);
  return vertical ? V2f(along, center) : V2f(center, along);
}

Bisection::Bisection(const StripRays& rays) : low_(0), high_(rays.strips - 1) {
  Choose(rays, MiddleStrip(rays.strips));
}

void Bisection::Narrow(const StripRays& rays) { Choose(rays, Next()); }

void Bisection::Choose(const StripRays& rays, int middle) {
  const auto difference = [&rays](int a, int b) {
    return (rays.colors[static_cast<std::size_t>(a)] -
            rays.colors[static_cast<std::size_t>(b)])
        .length2();
  };
  if (difference(low_, middle) + kNoise * kNoise < difference(middle, high_)) {
    low_ = middle;
  } else {
    high_ = middle;
  }
}

}  // namespace rtb
