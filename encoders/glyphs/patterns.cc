#include "encoders/glyphs/patterns.h"

#include <algorithm>
#include <array>

#include "core/base/check.h"

namespace rtb {
namespace {

constexpr std::array<char32_t, 16> kQuadrants = {
    U' ',   0x2598, 0x259D, 0x2580, 0x2596, 0x258C, 0x259E, 0x259B,
    0x2597, 0x259A, 0x2590, 0x259C, 0x2584, 0x2599, 0x259F, 0x2588};

/// A pattern that an older block already fills.
struct Older {
  unsigned pattern;
  char32_t glyph;
};

// Unicode 13, chapter 22: the names BLOCK SEXTANT-1 .. -23456 run through all
// 2 x 3 patterns in binary order, but for these.
constexpr Older kOlderSextants[] = {
    {0x00, U' '}, {0x15, 0x258C}, {0x2A, 0x2590}, {0x3F, 0x2588}};

// Unicode 16: the names BLOCK OCTANT-3 .. -2345678 run through all 2 x 4
// patterns in binary order, but for these.
constexpr Older kOlderOctants[] = {
    {0x00, U' '},    {0x01, 0x1CEA8}, {0x02, 0x1CEAB}, {0x03, 0x1FB82},
    {0x05, 0x2598},  {0x0A, 0x259D},  {0x0F, 0x2580},  {0x14, 0x1FBE6},
    {0x28, 0x1FBE7}, {0x3F, 0x1FB85}, {0x40, 0x1CEA3}, {0x50, 0x2596},
    {0x55, 0x258C},  {0x5A, 0x259E},  {0x5F, 0x259B},  {0x80, 0x1CEA0},
    {0xA0, 0x2597},  {0xA5, 0x259A},  {0xAA, 0x2590},  {0xAF, 0x259C},
    {0xC0, 0x2582},  {0xF0, 0x2584},  {0xF5, 0x2599},  {0xFA, 0x259F},
    {0xFC, 0x2586},  {0xFF, 0x2588}};

/// Numbers all patterns from `first` on, leaving out those in `older`.
template <std::size_t kCount, std::size_t kOlder>
std::array<char32_t, kCount> Numbered(char32_t first,
                                      const Older (&older)[kOlder]) {
  std::array<char32_t, kCount> glyphs{};
  for (const Older& block : older) glyphs[block.pattern] = block.glyph;
  for (char32_t& glyph : glyphs) {
    if (glyph == 0) glyph = first++;
  }
  return glyphs;
}

const std::array<char32_t, 64>& Sextants() {
  static const auto glyphs = Numbered<64>(0x1FB00, kOlderSextants);
  return glyphs;
}

const std::array<char32_t, 256>& Octants() {
  static const auto glyphs = Numbered<256>(0x1CD00, kOlderOctants);
  return glyphs;
}

template <class Glyphs>
char32_t At(const Glyphs& glyphs, unsigned pattern) {
  RTB_CHECK_LT(pattern, glyphs.size());
  return glyphs[pattern];
}

template <class Glyphs>
std::optional<GlyphPattern> Find(const Glyphs& glyphs, int rows,
                                 char32_t glyph) {
  const auto found = std::find(glyphs.begin(), glyphs.end(), glyph);
  if (found == glyphs.end()) return std::nullopt;
  return GlyphPattern{2, rows, static_cast<unsigned>(found - glyphs.begin())};
}

}  // namespace

char32_t QuadrantGlyph(unsigned pattern) { return At(kQuadrants, pattern); }
char32_t SextantGlyph(unsigned pattern) { return At(Sextants(), pattern); }
char32_t OctantGlyph(unsigned pattern) { return At(Octants(), pattern); }

char32_t BrailleGlyph(unsigned pattern) {
  RTB_CHECK_LT(pattern, 256u);
  // Dots 1-3 and 7 run down the left column, 4-6 and 8 down the right one;
  // dot n is bit n - 1 of the code point (Unicode 3, block "Braille
  // Patterns").
  constexpr unsigned kDots[] = {0x01, 0x08, 0x02, 0x10, 0x04, 0x20, 0x40, 0x80};
  char32_t glyph = 0x2800;
  for (unsigned i = 0; i < 8; ++i) {
    if ((pattern >> i & 1) != 0) glyph |= kDots[i];
  }
  return glyph;
}

std::vector<char32_t> GlyphsOfPatterns(char32_t (*glyph)(unsigned), int bits) {
  std::vector<char32_t> glyphs;
  for (unsigned pattern = 0; pattern < 1u << bits; ++pattern) {
    glyphs.push_back(glyph(pattern));
  }
  return glyphs;
}

std::optional<GlyphPattern> PatternOf(char32_t glyph) {
  if (const auto found = Find(kQuadrants, 2, glyph)) return found;
  if (const auto found = Find(Sextants(), 3, glyph)) return found;
  return Find(Octants(), 4, glyph);
}

}  // namespace rtb
