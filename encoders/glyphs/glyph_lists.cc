#include "encoders/glyphs/glyph_lists.h"

#include <algorithm>
#include <cstdint>

#include "core/base/suggest.h"
#include "encoders/cell.h"

namespace rtb {
namespace {

using Glyphs = std::vector<char32_t>;

/// Code points first..last.
struct Range {
  char32_t first;
  char32_t last;
};

struct NamedList {
  const char* name;
  std::vector<Range> ranges;
};

/// A glyph of TerminalImageViewer's with its bitmap.
struct TivGlyph {
  std::uint32_t pattern;
  char32_t code_point;
};

constexpr TivGlyph kTivGlyphs[] = {
#include "encoders/tiv_table.inc"
};

bool IsBlockElement(char32_t glyph) {
  return glyph >= 0x2580 && glyph <= 0x259F;
}

/// The lines, corners and squares among TerminalImageViewer's glyphs.
std::vector<Range> BoxRanges() {
  std::vector<Range> ranges;
  for (const TivGlyph& glyph : kTivGlyphs) {
    const char32_t code = glyph.code_point;
    if (code == kNoBreakSpace || IsBlockElement(code)) continue;
    ranges.push_back({code, code});
  }
  return ranges;
}

const std::vector<NamedList>& Lists() {
  static const std::vector<NamedList> lists = {
      {"blocks",
       {{0x2580, 0x2580},
        {0x2584, 0x2584},
        {0x258C, 0x258C},
        {0x2590, 0x2590}}},
      {"eighths", {{0x2581, 0x2587}, {0x2589, 0x258F}, {0x2594, 0x2595}}},
      {"quadrants", {{0x2596, 0x259F}}},
      {"shades", {{0x2591, 0x2593}}},
      {"sextants", {{0x1FB00, 0x1FB3B}}},
      {"wedges", {{0x1FB3C, 0x1FB6F}}},
      // With what older blocks lack to complete the octants: quarter rows,
      // middle halves of a side and quarter-height quadrants.
      {"octants",
       {{0x1CD00, 0x1CDE5},
        {0x2582, 0x2582},
        {0x2586, 0x2586},
        {0x1FB82, 0x1FB82},
        {0x1FB85, 0x1FB85},
        {0x1FBE6, 0x1FBE7},
        {0x1CEA0, 0x1CEA0},
        {0x1CEA3, 0x1CEA3},
        {0x1CEA8, 0x1CEA8},
        {0x1CEAB, 0x1CEAB}}},
      {"braille", {{0x2800, 0x28FF}}},
      {"box", BoxRanges()},
      {"ascii", {{0x0020, 0x007E}}}};
  return lists;
}

Status AddList(std::string_view name, const std::string& place,
               Glyphs& glyphs) {
  for (const NamedList& list : Lists()) {
    if (list.name != name) continue;
    for (const Range& range : list.ranges) {
      for (char32_t c = range.first; c <= range.last; ++c) glyphs.push_back(c);
    }
    return {};
  }
  const std::vector<std::string> names = GlyphListNames();
  std::string hint = DidYouMean(name, names);
  if (hint.empty()) hint = "join names with +";
  return Fail(BadInput(place,
                       "no glyph list `" + std::string(name) + "`; there are " +
                           JoinNames(names),
                       hint));
}

}  // namespace

std::vector<std::string> GlyphListNames() {
  std::vector<std::string> names;
  for (const NamedList& list : Lists()) names.emplace_back(list.name);
  return names;
}

Result<std::vector<char32_t>> GlyphsOf(std::string_view names,
                                       const std::string& place) {
  Glyphs glyphs = {U' ', kFullBlock};
  for (std::size_t begin = 0; begin <= names.size();) {
    const std::size_t end = std::min(names.find('+', begin), names.size());
    RTB_RETURN_IF_ERROR(
        AddList(names.substr(begin, end - begin), place, glyphs));
    begin = end + 1;
  }
  std::ranges::sort(glyphs);
  const auto repeated = std::ranges::unique(glyphs);
  glyphs.erase(repeated.begin(), repeated.end());
  return glyphs;
}

}  // namespace rtb
