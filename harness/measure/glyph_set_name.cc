#include "harness/measure/glyph_set_name.h"

#include <algorithm>
#include <set>

#include "core/base/check.h"
#include "encoders/cell.h"
#include "encoders/glyphs/glyph_lists.h"

namespace rtb {
namespace {

using Glyphs = std::set<char32_t>;

Glyphs WithoutSolid(std::span<const char32_t> glyphs) {
  Glyphs set(glyphs.begin(), glyphs.end());
  set.erase(U' ');
  set.erase(kNoBreakSpace);
  set.erase(kFullBlock);
  return set;
}

bool Contains(const Glyphs& all, const Glyphs& part) {
  return std::ranges::includes(all, part);
}

}  // namespace

std::string GlyphSetName(std::span<const char32_t> glyphs) {
  const Glyphs set = WithoutSolid(glyphs);
  if (!set.empty() && Contains({U'▀', U'▄'}, set)) return "half";
  std::string names;
  Glyphs named;
  for (const std::string& name : GlyphListNames()) {
    const auto list = GlyphsOf(name);
    RTB_CHECK(list.has_value());
    const Glyphs part = WithoutSolid(*list);
    if (part.empty() || !Contains(set, part) || Contains(named, part)) continue;
    names += (names.empty() ? "" : "+") + name;
    named.insert(part.begin(), part.end());
  }
  if (!names.empty() && named == set) return names;
  return std::to_string(glyphs.size()) + " glyphs";
}

}  // namespace rtb
