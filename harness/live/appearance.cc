#include "harness/live/appearance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "encoders/glyphs/mask.h"
#include "encoders/glyphs/shape.h"

namespace rtb {

const std::optional<AppearanceTable::Coverage>& AppearanceTable::CoverageOf(
    char32_t glyph) {
  const auto found = seen_.find(glyph);
  if (found != seen_.end()) return found->second;
  std::optional<Coverage> coverage;
  if (const auto shape = ShapeOf(glyph)) {
    const Mask mask = RasterizeShape(*shape, kColumns, kRows);
    coverage.emplace();
    std::copy(mask.coverage.begin(), mask.coverage.end(), coverage->begin());
  }
  return seen_.emplace(glyph, coverage).first->second;
}

float AppearanceTable::Difference(const Cell& a, const Cell& b) {
  if (Canonical(a) == Canonical(b)) return 0;
  // References into an unordered_map stay valid when it grows.
  const auto& of_a = CoverageOf(a.glyph);
  const auto& of_b = CoverageOf(b.glyph);
  if (!of_a || !of_b) return std::numeric_limits<float>::infinity();
  float sum = 0;
  for (const auto channel : {&Rgb8::r, &Rgb8::g, &Rgb8::b}) {
    const float a_bg = a.bg.*channel;
    const float b_bg = b.bg.*channel;
    const float a_span = static_cast<float>(a.fg.*channel) - a_bg;
    const float b_span = static_cast<float>(b.fg.*channel) - b_bg;
    for (std::size_t i = 0; i < of_a->size(); ++i) {
      const float difference =
          (a_bg + a_span * (*of_a)[i]) - (b_bg + b_span * (*of_b)[i]);
      sum += difference * difference;
    }
  }
  return std::sqrt(sum / (3 * kColumns * kRows));
}

}  // namespace rtb
