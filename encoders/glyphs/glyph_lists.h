/// @file
/// Glyph lists: the named sets of glyphs that encoders may choose from.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace rtb {

/// blocks, eighths, quadrants, shades, sextants, wedges, octants, braille,
/// box and ascii, in that order.
std::vector<std::string> GlyphListNames();

/// The code points of `NAME[+NAME...]`, sorted, each once. Space and full
/// block belong to every list.
/// @param place what an Error names as its place.
/// @return kBadInput that lists the names for one that is unknown.
Result<std::vector<char32_t>> GlyphsOf(std::string_view names,
                                       const std::string& place = "glyphs");

}  // namespace rtb
