#include "encoders/glyphs/shape.h"

#include <utility>

#include "encoders/cell.h"
#include "encoders/glyphs/patterns.h"
#include "encoders/glyphs/wedges.h"

namespace rtb {
namespace {

constexpr int kAll = kShapeUnits;
constexpr int kEighth = kShapeUnits / 8;
constexpr int kNinth = kShapeUnits / 9;

GlyphShape Block(const ShapeRect& rect, int quarters = 4) {
  return {{rect}, {}, quarters};
}

GlyphShape Rows(int top, int bottom) { return Block({0, top, kAll, bottom}); }

GlyphShape Columns(int left, int right) {
  return Block({left, 0, right, kAll});
}

/// Glyphs of one rectangle that no pattern of sub-cells names, and shades.
std::optional<GlyphShape> SimpleShape(char32_t glyph) {
  const int code = static_cast<int>(glyph);
  if (glyph >= 0x2581 && glyph <= 0x2588) {  // LOWER n EIGHTHS .. FULL BLOCK
    return Rows(kAll - (code - 0x2580) * kEighth, kAll);
  }
  if (glyph >= 0x2589 && glyph <= 0x258F) {  // LEFT 7 .. 1 EIGHTHS
    return Columns(0, (0x2590 - code) * kEighth);
  }
  if (glyph >= 0x2591 && glyph <= 0x2593) {  // LIGHT, MEDIUM, DARK SHADE
    return Block({0, 0, kAll, kAll}, code - 0x2590);
  }
  switch (glyph) {
    case U' ':
    case kNoBreakSpace:
      return GlyphShape{};
    case 0x2580:  // UPPER HALF BLOCK
      return Rows(0, kAll / 2);
    case 0x2590:  // RIGHT HALF BLOCK
      return Columns(kAll / 2, kAll);
    case 0x2594:  // UPPER ONE EIGHTH BLOCK
      return Rows(0, kEighth);
    case 0x2595:  // RIGHT ONE EIGHTH BLOCK
      return Columns(kAll - kEighth, kAll);
    case 0x23BA:  // HORIZONTAL SCAN LINE-1
      return Rows(0, kNinth);
    case 0x23BB:  // HORIZONTAL SCAN LINE-3
      return Rows(2 * kNinth, 3 * kNinth);
    case 0x23BC:  // HORIZONTAL SCAN LINE-7
      return Rows(6 * kNinth, 7 * kNinth);
    case 0x23BD:  // HORIZONTAL SCAN LINE-9
      return Rows(8 * kNinth, kAll);
    default:
      return std::nullopt;
  }
}

/// A rectangle for each sub-cell, those side by side joined.
GlyphShape ShapeOfPattern(const GlyphPattern& pattern) {
  GlyphShape shape;
  const int width = kShapeUnits / pattern.columns;
  const int height = kShapeUnits / pattern.rows;
  for (int i = 0; i < pattern.columns * pattern.rows; ++i) {
    if ((pattern.pattern >> i & 1) == 0) continue;
    const int left = i % pattern.columns * width;
    const int top = i / pattern.columns * height;
    if (!shape.rects.empty() && shape.rects.back().top == top &&
        shape.rects.back().right == left) {
      shape.rects.back().right += width;
    } else {
      shape.rects.push_back({left, top, left + width, top + height});
    }
  }
  return shape;
}

}  // namespace

std::optional<GlyphShape> ShapeOf(char32_t glyph) {
  if (auto shape = SimpleShape(glyph)) return shape;
  if (const auto pattern = PatternOf(glyph)) return ShapeOfPattern(*pattern);
  if (auto wedge = WedgeOf(glyph)) return GlyphShape{{}, {*std::move(wedge)}};
  return std::nullopt;
}

}  // namespace rtb
