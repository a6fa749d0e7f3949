/// @file
/// What a set of glyphs is called in records.
#pragma once

#include <span>
#include <string>

namespace rtb {

/// `half` for the half blocks, else the names of glyph lists that make up the
/// set joined by `+`, else `N glyphs`. Space and full block, which any grid may
/// hold, do not count.
/// @param glyphs rising code points.
std::string GlyphSetName(std::span<const char32_t> glyphs);

}  // namespace rtb
