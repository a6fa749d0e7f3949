#include "harness/live/panel.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "encoders/palette.h"

namespace rtb {
namespace {

LiveState StateOf(GridSize terminal) {
  LiveView view;
  view.scene = "street\x1b[2J";
  view.encoders = {"quadrant", "tiv"};
  LiveState state(view,
                  {{"quadrant", "tiv"}, {"cornell", "whitted"}, {"embree"}});
  state.Resize(terminal);
  return state;
}

std::u32string TextOf(const CellGrid& screen) {
  std::u32string text;
  for (const Cell& cell : screen.cells) text += cell.glyph;
  return text;
}

CellGrid Drawn(const LiveState& state, ColorDepth depth) {
  CellGrid screen(state.terminal());
  LiveReadings readings;
  readings.fps = 59.94;
  readings.rays_per_cell = 1.25;
  readings.graph = U"▁▂█";
  readings.quality = LiveQuality{0.0321, 0.00123, 16};
  DrawOverlays(state, readings, depth, &screen);
  return screen;
}

TEST(Panel, ShowsWhatWasMeasured) {
  LiveState state = StateOf({120, 40});
  state.modes().quality = true;
  const std::u32string text = TextOf(Drawn(state, ColorDepth::kTruecolor));
  for (const char32_t* part :
       {U"59.9 fps", U"1.25 per cell traced", U"▁▂█", U"quadrant", U"86 x 40",
        U"FLIP 0.0321  MSE 0.00123", U"? help"}) {
    EXPECT_NE(text.find(part), std::u32string::npos);
  }
}

TEST(Panel, LetsNoControlCharacterThrough) {
  const std::u32string text =
      TextOf(Drawn(StateOf({120, 40}), ColorDepth::kTruecolor));
  EXPECT_NE(text.find(U"street?[2J"), std::u32string::npos);
  EXPECT_TRUE(std::ranges::none_of(text, [](char32_t c) { return c < 32; }));
}

TEST(Panel, LinesFitAtUsualValues) {
  LiveReadings readings;
  readings.fps = 143.2;
  readings.target_fps = 144;
  readings.bytes_per_second = 12.34e6;
  readings.bytes_per_frame = 187.6e3;
  readings.share = 0.25;
  readings.row_step = 8;
  readings.color_reason = "answered";
  readings.present = "direct, sync, fence";
  for (const auto& line : PanelLines(StateOf({120, 40}), readings)) {
    EXPECT_LE(line.size(), 33u) << std::string(line.begin(), line.end());
  }
}

TEST(Panel, UsesTheTerminalsColors) {
  LiveState state = StateOf({120, 40});
  for (const ColorDepth depth : {ColorDepth::k256, ColorDepth::k16}) {
    const CellGrid screen = Drawn(state, depth);
    const CellRect& panel = state.layout().panel;
    for (int row = 0; row < panel.rows; ++row) {
      const Cell& cell = screen.at(panel.column, row);
      EXPECT_TRUE(IndexOf(cell.bg, depth).has_value());
    }
  }
}

TEST(Panel, HelpAndListsFitIntoAnyTerminal) {
  for (const GridSize size : {GridSize{1, 1}, GridSize{7, 3}, GridSize{40, 10},
                              GridSize{120, 40}, GridSize{400, 120}}) {
    LiveState state = StateOf(size);
    state.Apply(LiveCommand::kHelp);
    Drawn(state, ColorDepth::kTruecolor);
    state.Apply(LiveCommand::kScenePicker);
    Drawn(state, ColorDepth::kTruecolor);
  }
}

TEST(Panel, HelpNamesEveryKey) {
  for (const GridSize size : {GridSize{120, 60}, GridSize{80, 24}}) {
    LiveState state = StateOf(size);
    state.Apply(LiveCommand::kHelp);
    const std::u32string text = TextOf(Drawn(state, ColorDepth::kTruecolor));
    for (const KeyBinding& row : KeyBindings()) {
      if (row.label == nullptr) continue;
      EXPECT_NE(text.find(Glyphs(row.text)), std::u32string::npos) << row.text;
    }
  }
}

}  // namespace
}  // namespace rtb
