#include "encoders/search/split.h"

#include <cmath>

#include "core/base/check.h"

namespace rtb {
namespace {

constexpr int kEighths = 8;

/// Colors added up.
struct Sum {
  V3d total{0};
  int count = 0;

  void Add(const V3d& color) {
    total += color;
    ++count;
  }
  V3d Mean() const { return total / count; }
};

}  // namespace

EdgeSplit SplitAfter(const StripRays& rays, int k) {
  Sum first;
  Sum second;
  for (int strip = 0; strip < rays.strips; ++strip) {
    if (!rays.Has(strip)) continue;
    (strip < k ? first : second)
        .Add(rays.colors[static_cast<std::size_t>(strip)]);
  }
  RTB_CHECK(first.count > 0 && second.count > 0);
  const double n = rays.strips;
  EdgeSplit split;
  split.direction = rays.direction;
  split.eighths = static_cast<int>(std::lround(kEighths * k / n));
  split.first = first.Mean();
  split.second = second.Mean();
  split.strength =
      (split.first - split.second).length2() * (k / n) * (1 - k / n);
  return split;
}

EdgeSplit StrongestSplit(const StripRays& rays) {
  EdgeSplit best = SplitAfter(rays, 1);
  for (int k = 2; k < rays.strips; ++k) {
    const EdgeSplit split = SplitAfter(rays, k);
    if (IsStronger(split, best)) best = split;
  }
  return best;
}

EdgeSplit StrongestSplit(std::span<const PlacedRay> rays) {
  EdgeSplit best;
  for (const auto direction : kDirections) {
    const bool vertical = direction == SearchDirection::kVertical;
    for (int eighths = 1; eighths < kEighths; ++eighths) {
      Sum first;
      Sum second;
      for (const PlacedRay& ray : rays) {
        const float at = vertical ? ray.position.y : ray.position.x;
        (at * kEighths < static_cast<float>(eighths) ? first : second)
            .Add(ray.color);
      }
      if (first.count == 0 || second.count == 0) continue;
      const double share = first.count / static_cast<double>(rays.size());
      EdgeSplit split{direction, eighths, 0, first.Mean(), second.Mean()};
      split.strength =
          (split.first - split.second).length2() * share * (1 - share);
      if (IsStronger(split, best)) best = split;
    }
  }
  return best;
}

bool IsStronger(const EdgeSplit& split, const EdgeSplit& best) {
  return split.strength > best.strength + kNoise * std::sqrt(best.strength);
}

Cell CellOfSplit(Blend blend, const EdgeSplit& split) {
  const auto eighths = static_cast<char32_t>(split.eighths);
  const Rgb8 first = ToRgb8(blend, split.first);
  const Rgb8 second = ToRgb8(blend, split.second);
  if (split.direction == SearchDirection::kVertical) {
    return {U'\u2588' - eighths, second, first};  // LOWER n EIGHTHS BLOCK
  }
  return {0x2590 - eighths, first, second};  // LEFT n EIGHTHS BLOCK
}

}  // namespace rtb
