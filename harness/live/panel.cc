#include "harness/live/panel.h"

#include <algorithm>
#include <cstdarg>
#include <cstdio>
#include <limits>

#include "encoders/palette.h"

namespace rtb {
namespace {

constexpr Rgb8 kBackground{18, 20, 28};
constexpr Rgb8 kForeground{205, 205, 205};
constexpr Rgb8 kBright{255, 255, 255};
constexpr Rgb8 kFaint{127, 127, 127};

/// printf into glyphs.
__attribute__((format(printf, 1, 2))) std::u32string Format(const char* format,
                                                            ...) {
  char text[256];
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  return Glyphs(text);
}

/// The color of the depth that is nearest.
Rgb8 Nearest(Rgb8 color, ColorDepth depth) {
  if (depth == ColorDepth::kTruecolor) return color;
  Rgb8 best;
  int least = std::numeric_limits<int>::max();
  for (const Rgb8& candidate : PaletteColors(depth)) {
    const int r = candidate.r - color.r;
    const int g = candidate.g - color.g;
    const int b = candidate.b - color.b;
    const int distance = r * r + g * g + b * b;
    if (distance >= least) continue;
    least = distance;
    best = candidate;
  }
  return best;
}

TextColors Colors(Rgb8 fg, ColorDepth depth) {
  return {Nearest(fg, depth), Nearest(kBackground, depth)};
}

void AddEncoders(const LiveState& state, std::vector<std::u32string>* lines) {
  const LiveView& view = state.view();
  if (!view.split) {
    lines->push_back(Glyphs("encoder  " + view.encoders[0]));
    return;
  }
  for (std::size_t side = 0; side < 2; ++side) {
    const std::string name = side == 0 ? "left" : "right";
    const std::string mark = state.modes().side == side ? "*" : " ";
    lines->push_back(Glyphs(name + mark + std::string(side == 0 ? 4 : 3, ' ') +
                            view.encoders[side]));
  }
}

std::string Movement(const LiveState& state) {
  const LiveModes& modes = state.modes();
  if (modes.orbit) return "orbit";
  if (!state.animated()) return "none";
  return modes.playing ? "playing" : "paused";
}

void AddQuality(const LiveState& state, const LiveReadings& readings,
                std::vector<std::u32string>* lines) {
  if (!state.modes().quality) return;
  if (!readings.quality) {
    lines->push_back(U"quality  waits for a still picture");
    return;
  }
  lines->push_back(Format("FLIP %.4f  MSE %.5f", readings.quality->flip,
                          readings.quality->mse));
  lines->push_back(
      Format("  against %d rays a pixel", readings.quality->passes));
}

void AddRays(const LiveState& state, const LiveReadings& r,
             std::vector<std::u32string>* lines) {
  lines->push_back(Format("rays     %.2f M/s", r.rays_per_second * 1e-6));
  lines->push_back(Format("         %.2f per cell traced", r.rays_per_cell));
  if (r.row_step > 1) {
    lines->push_back(Format("governor %.0f %% of samples, rows/%d",
                            r.share * 100, r.row_step));
  } else if (r.share < 1) {
    lines->push_back(Format("governor %.0f %% of samples", r.share * 100));
  } else {
    lines->push_back(state.modes().governor ? U"governor all samples"
                                            : U"governor off");
  }
  lines->push_back(Format("rest     %d rays a sample", r.passes));
}

/// Columns wide, over the picture's middle.
CellRect Centered(GridSize screen, int columns, int rows) {
  columns = std::min(columns, screen.columns);
  rows = std::min(rows, screen.rows);
  return {(screen.columns - columns) / 2, (screen.rows - rows) / 2, columns,
          rows};
}

void DrawHelp(ColorDepth depth, CellGrid* screen) {
  std::vector<HelpLine> lines(MotionHelp().begin(), MotionHelp().end());
  for (const KeyBinding& row : KeyBindings()) {
    if (row.label != nullptr) lines.push_back({row.label, row.text});
  }
  // In two columns where one is too high.
  constexpr int kColumn = 40;
  const int count = static_cast<int>(lines.size());
  const bool two = count + 2 > screen->size.rows;
  const int rows = two ? (count + 1) / 2 : count;
  const CellRect rect =
      Centered(screen->size, two ? 2 * kColumn : kColumn + 2, rows + 2);
  FillRect(rect, Nearest(kBackground, depth), screen);
  const int top = rect.rows > rows ? 1 : 0;
  for (int i = 0; i < count; ++i) {
    const HelpLine& line = lines[static_cast<std::size_t>(i)];
    const int left = i / rows * kColumn + 1;
    const int row = top + i % rows;
    DrawText(rect, left, row, Glyphs(line.label), Colors(kBright, depth),
             screen);
    DrawText(rect, left + 9, row, Glyphs(line.text), Colors(kForeground, depth),
             screen);
  }
}

void DrawPicker(const LiveState& state, ColorDepth depth, CellGrid* screen) {
  const auto& scenes = state.choices().scenes;
  const CellRect rect =
      Centered(screen->size, 40, static_cast<int>(scenes.size()) + 4);
  FillRect(rect, Nearest(kBackground, depth), screen);
  DrawText(rect, 2, 1, U"scene: arrows, Enter, Esc", Colors(kFaint, depth),
           screen);
  // Scrolled so that the chosen one is seen.
  const int room = std::max(rect.rows - 4, 1);
  const int picked = static_cast<int>(state.modes().picked);
  const int first = std::max(0, picked - room + 1);
  for (int i = first; i < static_cast<int>(scenes.size()) && i < first + room;
       ++i) {
    const std::string mark = i == picked ? "> " : "  ";
    DrawText(rect, 2, 3 + i - first,
             Glyphs(mark + scenes[static_cast<std::size_t>(i)]),
             Colors(i == picked ? kBright : kForeground, depth), screen);
  }
}

void DrawPanel(const LiveState& state, const LiveReadings& readings,
               ColorDepth depth, CellGrid* screen) {
  const CellRect& rect = state.layout().panel;
  FillRect(rect, Nearest(kBackground, depth), screen);
  int row = 0;
  for (const std::u32string& line : PanelLines(state, readings)) {
    DrawText(rect, 1, row, line,
             Colors(row == 0 ? kBright : kForeground, depth), screen);
    ++row;
  }
  const auto& log = state.log();
  const int room = std::max(rect.rows - row - 1, 0);
  const int shown = std::min(room, static_cast<int>(log.size()));
  for (int i = 0; i < shown; ++i) {
    const auto at = log.size() - static_cast<std::size_t>(shown - i);
    DrawText(rect, 1, rect.rows - shown + i, Glyphs(log[at]),
             Colors(kFaint, depth), screen);
  }
}

void DrawStatus(const LiveState& state, const LiveReadings& readings,
                ColorDepth depth, CellGrid* screen) {
  const CellRect& rect = state.layout().status;
  FillRect(rect, Nearest(kBackground, depth), screen);
  const std::string last = state.log().empty() ? "" : state.log().back();
  const std::u32string line =
      Format("%.0f fps %.1f ms ", readings.fps, readings.frame_p50_ms) +
      Glyphs(state.view().encoders[0] + " " + state.view().scene + "  " + last);
  DrawText(rect, 0, 0, line, Colors(kForeground, depth), screen);
}

}  // namespace

std::vector<std::u32string> PanelLines(const LiveState& state,
                                       const LiveReadings& r) {
  const LiveView& view = state.view();
  std::vector<std::u32string> lines;
  lines.push_back(Format("%.1f fps  of %.0f%s", r.fps, r.target_fps,
                         r.recording ? "  REC" : ""));
  lines.push_back(
      Format("frame    %.1f ms  p99 %.1f", r.frame_p50_ms, r.frame_p99_ms));
  lines.push_back(Format("render %.1f encode %.1f draw %.1f", r.render_ms,
                         r.encode_ms, r.draw_ms));
  lines.push_back(r.graph);
  AddRays(state, r, &lines);
  lines.push_back(Format("out      %.1f MB/s  %.1f KB each",
                         r.bytes_per_second * 1e-6, r.bytes_per_frame * 1e-3));
  lines.push_back(Format("         %.0f %% of cells", r.changed * 100));
  if (r.ack_ms > 0) lines.push_back(Format("terminal %.1f ms", r.ack_ms));
  AddEncoders(state, &lines);
  lines.push_back(Glyphs("scene    " + view.scene));
  lines.push_back(
      Format("grid     %d x %d", view.grid.columns, view.grid.rows));
  lines.push_back(Glyphs("trace    " + view.backend + ", " + view.integrator +
                         ", spp " + std::to_string(view.spp)));
  lines.push_back(Format("exposure %+.2f stops", r.exposure));
  lines.push_back(Glyphs("movement " + Movement(state)) +
                  Format("  t %.2f s", view.time));
  lines.push_back(Glyphs(std::string("colors   ") + NameOf(view.depth) + " (" +
                         r.color_reason + ")"));
  lines.push_back(Glyphs("present  " + r.present));
  AddQuality(state, r, &lines);
  lines.push_back(U"? help   ^C quit");
  return lines;
}

void DrawOverlays(const LiveState& state, const LiveReadings& readings,
                  ColorDepth depth, CellGrid* screen) {
  if (state.layout().panel.columns > 0) {
    DrawPanel(state, readings, depth, screen);
  }
  if (state.layout().status.rows > 0) {
    DrawStatus(state, readings, depth, screen);
  }
  if (state.modes().help) DrawHelp(depth, screen);
  if (state.modes().picker) DrawPicker(state, depth, screen);
}

}  // namespace rtb
