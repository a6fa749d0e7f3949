#include <cstdio>
#include <optional>

#include "encoders/emit/emit.h"
#include "encoders/emit/hex_color.h"
#include "encoders/glyphs/shape.h"

namespace rtb {
namespace {

// DejaVu Sans Mono, in units of its em (hhea and hmtx tables).
constexpr double kEm = 2048;
constexpr double kAdvance = 1233 / kEm;
constexpr double kAscender = 1901 / kEm;
constexpr double kDescender = 483 / kEm;

/// A figure without trailing zeros.
std::string Number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.8g", value);
  return text;
}

std::string Attribute(const char* name, const std::string& value) {
  return std::string(" ") + name + "=\"" + value + "\"";
}

std::string EscapedXml(char32_t glyph) {
  switch (glyph) {
    case U'&':
      return "&amp;";
    case U'<':
      return "&lt;";
    case U'>':
      return "&gt;";
    default:
      return Utf8(glyph);
  }
}

/// A filled rectangle in 72nds of cells, from the picture's top left.
struct Fill {
  ShapeRect rect;
  Rgb8 color;
  int quarters = 4;

  /// Whether `next` goes on where this one ends.
  bool Continues(const Fill& next) const {
    return next.rect.left == rect.right && next.rect.top == rect.top &&
           next.rect.bottom == rect.bottom && next.color == color &&
           next.quarters == quarters;
  }
};

class SvgWriter {
 public:
  SvgWriter(const CellGrid& grid, int cell_width, int cell_height)
      : grid_(grid), cell_width_(cell_width), cell_height_(cell_height) {}

  std::string Write() {
    Open();
    for (int row = 0; row < grid_.size.rows; ++row) AddBackgrounds(row);
    for (int row = 0; row < grid_.size.rows; ++row) AddGlyphs(row);
    return text_ + "</svg>\n";
  }

 private:
  void Open() {
    const std::string width = Number(grid_.size.columns * cell_width_);
    const std::string height = Number(grid_.size.rows * cell_height_);
    text_ = "<svg xmlns=\"http://www.w3.org/2000/svg\"" +
            Attribute("width", width) + Attribute("height", height) +
            Attribute("viewBox", "0 0 " + width + " " + height) +
            Attribute("shape-rendering", "crispEdges") +
            Attribute("font-family",
                      "'DejaVu Sans Mono', 'DejaVu Sans', monospace") +
            Attribute("font-size", Number(cell_width_ / kAdvance)) + ">\n";
  }

  void AddBackgrounds(int row) {
    for (int column = 0; column < grid_.size.columns; ++column) {
      const Cell& cell = grid_.at(column, row);
      if (cell.glyph == kFullBlock) continue;
      const ShapeRect whole{0, 0, kShapeUnits, kShapeUnits};
      Add({Moved(whole, column, row), cell.bg});
    }
    Flush();
  }

  void AddGlyphs(int row) {
    for (int column = 0; column < grid_.size.columns; ++column) {
      const Cell& cell = grid_.at(column, row);
      if (const auto shape = ShapeOf(cell.glyph)) {
        for (const ShapeRect& rect : shape->rects) {
          Add({Moved(rect, column, row), cell.fg, shape->quarters});
        }
        for (const ShapePolygon& polygon : shape->polygons) {
          Flush();
          AddPolygon(polygon, cell.fg, column, row);
        }
      } else {
        Flush();
        AddText(cell, column, row);
      }
    }
    Flush();
  }

  static ShapeRect Moved(const ShapeRect& rect, int column, int row) {
    const int x = column * kShapeUnits;
    const int y = row * kShapeUnits;
    return {rect.left + x, rect.top + y, rect.right + x, rect.bottom + y};
  }

  /// Joins a rectangle with the one before where it can.
  void Add(const Fill& fill) {
    if (pending_ && pending_->Continues(fill)) {
      pending_->rect.right = fill.rect.right;
      return;
    }
    Flush();
    pending_ = fill;
  }

  void Flush() {
    if (!pending_) return;
    const ShapeRect& rect = pending_->rect;
    text_ += "<rect" + Attribute("x", Across(rect.left)) +
             Attribute("y", Down(rect.top)) +
             Attribute("width", Across(rect.right - rect.left)) +
             Attribute("height", Down(rect.bottom - rect.top)) +
             Attribute("fill", HexColor(pending_->color));
    if (pending_->quarters < 4) {
      text_ += Attribute("fill-opacity", Number(pending_->quarters / 4.0));
    }
    text_ += "/>\n";
    pending_.reset();
  }

  /// Slanted edges are not to be drawn in steps.
  void AddPolygon(const ShapePolygon& polygon, Rgb8 color, int column,
                  int row) {
    std::string points;
    for (const ShapePoint& point : polygon) {
      if (!points.empty()) points += ' ';
      points += Across(point.x + column * kShapeUnits) + "," +
                Down(point.y + row * kShapeUnits);
    }
    text_ += "<polygon" + Attribute("points", points) +
             Attribute("fill", HexColor(color)) +
             Attribute("shape-rendering", "geometricPrecision") + "/>\n";
  }

  void AddText(const Cell& cell, int column, int row) {
    // The font's place in the cell is that of the masks (glyphs/font.h).
    const double size = cell_width_ / kAdvance;
    const double rest = cell_height_ - (kAscender + kDescender) * size;
    const double baseline = row * cell_height_ + rest / 2 + kAscender * size;
    text_ += "<text" + Attribute("x", Number(column * cell_width_)) +
             Attribute("y", Number(baseline)) +
             Attribute("textLength", Number(cell_width_)) +
             Attribute("lengthAdjust", "spacingAndGlyphs") +
             Attribute("fill", HexColor(cell.fg)) + ">" +
             EscapedXml(cell.glyph) + "</text>\n";
  }

  std::string Across(int units) const {
    return Number(static_cast<double>(units) * cell_width_ / kShapeUnits);
  }
  std::string Down(int units) const {
    return Number(static_cast<double>(units) * cell_height_ / kShapeUnits);
  }

  const CellGrid& grid_;
  int cell_width_;
  int cell_height_;
  std::string text_;
  std::optional<Fill> pending_;
};

}  // namespace

std::string EmitSvg(const CellGrid& grid, int cell_width, int cell_height) {
  return SvgWriter(grid, cell_width, cell_height).Write();
}

}  // namespace rtb
