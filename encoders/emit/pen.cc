#include "encoders/emit/pen.h"

#include <charconv>
#include <optional>

#include "core/base/check.h"
#include "encoders/emit/emit.h"
#include "encoders/palette.h"

namespace rtb {
namespace {

bool ShowsForeground(const Cell& cell) {
  return cell.glyph != U' ' && cell.glyph != kNoBreakSpace;
}
bool ShowsBackground(const Cell& cell) { return cell.glyph != kFullBlock; }

void AppendNumber(int number, std::string* text) {
  char digits[12];
  const auto result = std::to_chars(digits, digits + sizeof digits, number);
  text->append(digits, result.ptr);
}

/// The parameters that set a color: as the foreground, or as the background,
/// whose codes are 10 higher. ECMA-48, section 8.3.117; xterm's ctlseqs.
void AppendColor(Rgb8 color, bool background, ColorDepth depth,
                 std::string* text) {
  const int shift = background ? 10 : 0;
  if (depth == ColorDepth::kTruecolor) {
    text->append(background ? "48;2;" : "38;2;");
    AppendNumber(color.r, text);
    text->push_back(';');
    AppendNumber(color.g, text);
    text->push_back(';');
    AppendNumber(color.b, text);
    return;
  }
  const std::optional<int> index = IndexOf(color, depth);
  RTB_CHECK(index.has_value());
  if (depth == ColorDepth::k256) {
    text->append(background ? "48;5;" : "38;5;");
    return AppendNumber(*index, text);
  }
  AppendNumber((*index < 8 ? 30 : 90 - 8) + *index + shift, text);
}

bool Changes(const Rgb8* wanted, const Rgb8* told) {
  return wanted != nullptr && (told == nullptr || *wanted != *told);
}

}  // namespace

std::vector<PenColors> WantedColors(std::span<const Cell> cells) {
  std::vector<PenColors> wanted(cells.size());
  PenColors next;
  for (std::size_t i = cells.size(); i-- > 0;) {
    if (ShowsForeground(cells[i])) next.fg = &cells[i].fg;
    if (ShowsBackground(cells[i])) next.bg = &cells[i].bg;
    wanted[i] = next;
  }
  return wanted;
}

void AnsiPen::Append(const Cell& cell, const PenColors& wanted,
                     std::string* text) {
  if (depth_ != ColorDepth::kMono) AppendColors(cell, wanted, text);
  *text += Utf8(cell.glyph);
}

void AnsiPen::AppendColors(const Cell& cell, const PenColors& wanted,
                           std::string* text) {
  const bool fg_changes = Changes(wanted.fg, told_.fg);
  const bool bg_changes = Changes(wanted.bg, told_.bg);
  const bool due = (fg_changes && ShowsForeground(cell)) ||
                   (bg_changes && ShowsBackground(cell));
  if (!due) return;
  text->append("\x1b[");
  if (fg_changes) AppendColor(*wanted.fg, false, depth_, text);
  if (fg_changes && bg_changes) text->push_back(';');
  if (bg_changes) AppendColor(*wanted.bg, true, depth_, text);
  text->push_back('m');
  told_ = wanted;
}

}  // namespace rtb
