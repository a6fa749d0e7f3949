#include "encoders/adaptive/found_rays.h"

#include <algorithm>
#include <functional>

namespace rtb {
namespace {

/// Of equal gains those of a cell's first rays count first.
constexpr std::size_t kFew = 2;

/// What the last of the wanted rays gains.
float LeastOf(std::span<const FoundRays> parts, int count,
              const GainThreshold& threshold) {
  const auto [from, to, above] = threshold.Of(count);
  std::vector<float> gains;
  for (const FoundRays& part : parts) {
    for (const RayChoice& ray : part.rays) {
      if (ray.gain >= from && ray.gain < to) gains.push_back(ray.gain);
    }
  }
  const auto nth = static_cast<std::size_t>(count - above);
  if (nth > gains.size()) return 0;
  const auto at = gains.begin() + static_cast<std::ptrdiff_t>(nth) - 1;
  std::nth_element(gains.begin(), at, gains.end(), std::greater<>());
  return *at;
}

/// Of the rays that gain `least` so many are taken, and whether later ones
/// than the first of their cells.
struct Equals {
  int count;
  bool later;
};
Equals EqualsOf(std::span<const FoundRays> parts, int count, float least) {
  int more = 0;
  int early = 0;  // Cells' first ones that gain as much.
  bool wanted = false;
  for (const FoundRays& part : parts) {
    for (std::size_t i = 0; i < part.rays.size(); ++i) {
      const float gain = part.rays[i].gain;
      if (gain > least) ++more;
      if (gain >= least && !part.IsLater(i, kFew)) ++early;
      if (gain > least && part.IsLater(i, kFew - 1)) wanted = true;
    }
  }
  return {count - more, wanted || early < count};
}

}  // namespace

std::vector<RayChoice> TakeBest(std::span<const FoundRays> parts, int count,
                                const GainThreshold& threshold) {
  const float least = LeastOf(parts, count, threshold);
  auto [equal, later] = EqualsOf(parts, count, least);
  std::vector<RayChoice> rays;
  rays.reserve(static_cast<std::size_t>(count));
  for (const FoundRays& part : parts) {
    for (std::size_t cell = 0; cell < part.at.size(); ++cell) {
      for (std::size_t i = 0; i < part.counts[cell]; ++i) {
        const RayChoice& ray = part.rays[part.at[cell] + i];
        if (ray.gain < least) break;
        if (ray.gain == least && ((!later && i >= kFew) || equal-- <= 0)) {
          break;
        }
        rays.push_back(ray);
      }
    }
  }
  return rays;
}

}  // namespace rtb
