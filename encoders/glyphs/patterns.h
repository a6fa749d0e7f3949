/// @file
/// Glyphs that fill a pattern of equal sub-cells. Bit 0 of a pattern = top
/// left, row by row.
#pragma once

#include <optional>
#include <vector>

namespace rtb {

/// The block element that fills the 2 x 2 pattern (0..15): space, U+2580,
/// U+2584, U+2588, U+258C, U+2590, U+2596-259F.
char32_t QuadrantGlyph(unsigned pattern);

/// The glyph that fills the 2 x 3 pattern (0..63): U+1FB00-1FB3B, or the
/// older block where Unicode has one.
char32_t SextantGlyph(unsigned pattern);

/// The glyph that fills the 2 x 4 pattern (0..255): U+1CD00-1CDE5, or the
/// other block where Unicode has one.
char32_t OctantGlyph(unsigned pattern);

/// The braille pattern (U+2800-28FF) with a dot in each sub-cell that the 2 x
/// 4 pattern (0..255) names.
char32_t BrailleGlyph(unsigned pattern);

/// The glyphs of all patterns of `bits` sub-cells, by pattern.
std::vector<char32_t> GlyphsOfPatterns(char32_t (*glyph)(unsigned), int bits);

/// Sub-cells in `columns` x `rows` that a glyph fills.
struct GlyphPattern {
  int columns;
  int rows;
  unsigned pattern;
};

/// The coarsest pattern by which a quadrant, sextant or octant glyph is
/// defined, if it is one.
std::optional<GlyphPattern> PatternOf(char32_t glyph);

}  // namespace rtb
