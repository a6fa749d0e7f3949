/// @file
/// AnsiPen: the colors that a terminal has been told, and the shortest SGR
/// sequence to the next cell's.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "encoders/cell.h"
#include "encoders/color_depth.h"

namespace rtb {

/// A pair of colors in given cells; nullptr where there is none.
struct PenColors {
  const Rgb8* fg = nullptr;
  const Rgb8* bg = nullptr;
};

/// For each of the cells, which are written in this order, the colors to be
/// told there. One that does not show is that of the next cell where it does:
/// when a sequence is due anyway, it brings it along. Points into `cells`.
std::vector<PenColors> WantedColors(std::span<const Cell> cells);

/// Writes cells one after the other.
class AnsiPen {
 public:
  /// @param depth all colors are PaletteColors(depth).
  explicit AnsiPen(ColorDepth depth) : depth_(depth) {}

  /// Whether a color has been told.
  bool used() const { return told_.fg != nullptr || told_.bg != nullptr; }

  /// Appends the sequence that a cell needs, if any, and its glyph.
  /// @param wanted of this cell; what it points at outlives the pen.
  void Append(const Cell& cell, const PenColors& wanted, std::string* text);

 private:
  void AppendColors(const Cell& cell, const PenColors& wanted,
                    std::string* text);

  ColorDepth depth_;
  PenColors told_;
};

}  // namespace rtb
