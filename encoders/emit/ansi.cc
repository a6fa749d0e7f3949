#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/check.h"
#include "encoders/emit/emit.h"
#include "encoders/palette.h"

namespace rtb {
namespace {

bool ShowsForeground(const Cell& cell) {
  return cell.glyph != U' ' && cell.glyph != kNoBreakSpace;
}
bool ShowsBackground(const Cell& cell) { return cell.glyph != kFullBlock; }

/// The parameters that set a color: as the foreground, or as the background,
/// whose codes are 10 higher. ECMA-48, section 8.3.117; xterm's ctlseqs.
std::string ColorParameters(Rgb8 color, bool background, ColorDepth depth) {
  const int shift = background ? 10 : 0;
  const auto text = [](int number) { return std::to_string(number); };
  if (depth == ColorDepth::kTruecolor) {
    return text(38 + shift) + ";2;" + text(color.r) + ";" + text(color.g) +
           ";" + text(color.b);
  }
  const std::optional<int> index = IndexOf(color, depth);
  RTB_CHECK(index.has_value());
  if (depth == ColorDepth::k256) return text(38 + shift) + ";5;" + text(*index);
  return text((*index < 8 ? 30 : 90 - 8) + *index + shift);
}

/// A pair of colors in a row's cells; nullptr where there is none.
struct Colors {
  const Rgb8* fg = nullptr;
  const Rgb8* bg = nullptr;
};

bool Changes(const Rgb8* wanted, const Rgb8* told) {
  return wanted != nullptr && (told == nullptr || *wanted != *told);
}

/// For each cell of a row the colors to be told there. One that does not show
/// is that of the next cell where it does: when a sequence is due anyway, it
/// brings it along.
std::vector<Colors> WantedColors(std::span<const Cell> cells) {
  std::vector<Colors> wanted(cells.size());
  Colors next;
  for (std::size_t i = cells.size(); i-- > 0;) {
    if (ShowsForeground(cells[i])) next.fg = &cells[i].fg;
    if (ShowsBackground(cells[i])) next.bg = &cells[i].bg;
    wanted[i] = next;
  }
  return wanted;
}

/// The colors that a terminal has been told since the row began.
class Pen {
 public:
  explicit Pen(ColorDepth depth) : depth_(depth) {}

  bool used() const { return told_.fg != nullptr || told_.bg != nullptr; }

  /// The sequence that a cell needs, if any.
  std::string Sequence(const Cell& cell, const Colors& wanted) {
    const bool fg_changes = Changes(wanted.fg, told_.fg);
    const bool bg_changes = Changes(wanted.bg, told_.bg);
    const bool due = (fg_changes && ShowsForeground(cell)) ||
                     (bg_changes && ShowsBackground(cell));
    if (!due) return "";
    std::string text = "\x1b[";
    if (fg_changes) text += ColorParameters(*wanted.fg, false, depth_);
    if (fg_changes && bg_changes) text += ';';
    if (bg_changes) text += ColorParameters(*wanted.bg, true, depth_);
    told_ = wanted;
    return text + 'm';
  }

 private:
  ColorDepth depth_;
  Colors told_;
};

std::string Row(std::span<const Cell> cells, ColorDepth depth) {
  const std::vector<Colors> wanted = WantedColors(cells);
  Pen pen(depth);
  std::string text;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (depth != ColorDepth::kMono) text += pen.Sequence(cells[i], wanted[i]);
    text += Utf8(cells[i].glyph);
  }
  return text + (pen.used() ? "\x1b[m\n" : "\n");
}

}  // namespace

std::string EmitAnsi(const CellGrid& grid, ColorDepth depth) {
  const std::span<const Cell> cells(grid.cells);
  const auto columns = static_cast<std::size_t>(grid.size.columns);
  std::string text;
  for (std::size_t row = 0; row * columns < cells.size(); ++row) {
    text += Row(cells.subspan(row * columns, columns), depth);
  }
  return text;
}

}  // namespace rtb
