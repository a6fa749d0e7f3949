#include "encoders/fit/atlas.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/check.h"

namespace rtb {
namespace {

/// Coverages are float: what differs by less is the same.
constexpr double kSame = 1e-6;

/// Whether coverage(i) of both masks agree, after `adapt` of the first.
template <class Adapt>
bool Agree(const FitMask& a, const FitMask& b, const Adapt& adapt) {
  return std::ranges::equal(a.coverage, b.coverage, [&](double x, double y) {
    return std::abs(adapt(x) - y) <= kSame;
  });
}

/// Index of the first candidate that agrees; -1 without one.
template <class Adapt>
int FindMask(std::span<const FitMask> candidates, const FitMask& mask,
             const Adapt& adapt) {
  const auto found = std::ranges::find_if(
      candidates,
      [&](const FitMask& candidate) { return Agree(candidate, mask, adapt); });
  return found == candidates.end()
             ? -1
             : static_cast<int>(found - candidates.begin());
}

}  // namespace

FitMask MakeFitMask(char32_t glyph, const Mask& mask) {
  FitMask made;
  made.glyph = glyph;
  RTB_CHECK(!mask.coverage.empty());
  for (const double m : mask.coverage) {
    const double whole = std::round(m);
    made.coverage.push_back(std::abs(m - whole) <= kSame ? whole : m);
  }
  const auto [low, high] = std::ranges::minmax(made.coverage);
  if (high - low <= kSame) std::ranges::fill(made.coverage, low);
  for (const double m : made.coverage) {
    made.sum += m;
    made.sum_squares += m * m;
  }
  if (high - low <= kSame) return made;
  const double mean = made.sum / made.size();
  for (const double m : made.coverage) {
    made.variance += (m - mean) * (m - mean);
  }
  return made;
}

std::vector<char32_t> Atlas::glyphs() const {
  std::vector<char32_t> glyphs;
  for (const FitMask& mask : candidates_) glyphs.push_back(mask.glyph);
  return glyphs;
}

int Atlas::Find(char32_t glyph) const {
  const auto found = index_.find(glyph);
  return found == index_.end() ? -1 : found->second;
}

void Atlas::Add(FitMask mask) {
  int index = FindMask(candidates_, mask, [](double m) { return m; });
  if (index < 0) {
    mask.complement =
        FindMask(candidates_, mask, [](double m) { return 1 - m; });
    index = static_cast<int>(candidates_.size());
    index_.emplace(mask.glyph, index);
    candidates_.push_back(std::move(mask));
  } else {
    index_.emplace(mask.glyph, index);
  }
}

Result<Atlas> MakeAtlas(std::span<const char32_t> glyphs, int width, int height,
                        MaskSource source, const std::filesystem::path& font) {
  RTB_CHECK(!glyphs.empty());
  RTB_CHECK(std::ranges::is_sorted(glyphs));
  GlyphSet masks(width, height, source, font);
  Atlas atlas(width, height);
  for (const char32_t glyph : glyphs) {
    RTB_ASSIGN_OR_RETURN(const Mask* const mask, masks.Get(glyph));
    atlas.Add(MakeFitMask(glyph, *mask));
  }
  return atlas;
}

}  // namespace rtb
