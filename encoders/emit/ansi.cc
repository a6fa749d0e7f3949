#include <optional>

#include "encoders/emit/emit.h"

namespace rtb {
namespace {

/// Colors that the terminal has been told since the line began.
struct Attributes {
  std::optional<Rgb8> fg;
  std::optional<Rgb8> bg;
};

/// Adds `38;2;r;g;b` (or 48) to the parameters of a CSI.
void AddColor(const char* which, Rgb8 color, std::string& parameters) {
  if (!parameters.empty()) parameters += ';';
  parameters += which;
  for (const int component : {color.r, color.g, color.b}) {
    parameters += ';' + std::to_string(component);
  }
}

/// One cell: the colors that changed and that the glyph shows, in one CSI, and
/// the glyph.
void AddCell(const Cell& cell, Attributes& told, std::string& text) {
  const bool fg_shows = cell.glyph != U' ' && cell.glyph != kNoBreakSpace;
  const bool bg_shows = cell.glyph != kFullBlock;
  std::string parameters;
  if (fg_shows && told.fg != cell.fg) {
    AddColor("38;2", cell.fg, parameters);
    told.fg = cell.fg;
  }
  if (bg_shows && told.bg != cell.bg) {
    AddColor("48;2", cell.bg, parameters);
    told.bg = cell.bg;
  }
  if (!parameters.empty()) text += "\x1b[" + parameters + "m";
  text += Utf8(cell.glyph);
}

}  // namespace

std::string EmitAnsi(const CellGrid& grid) {
  std::string text;
  for (int row = 0; row < grid.size.rows; ++row) {
    Attributes told;
    for (int column = 0; column < grid.size.columns; ++column) {
      AddCell(grid.at(column, row), told, text);
    }
    text += "\x1b[0m\n";
  }
  return text;
}

}  // namespace rtb
