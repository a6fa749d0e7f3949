#include "harness/live/ansi_frame.h"

#include <gtest/gtest.h>

#include <random>

#include "encoders/palette.h"
#include "encoders/parse/parse.h"
#include "harness/live/screen_diff.h"

namespace rtb {
namespace {

/// Random glyphs in random colors of a depth.
class RandomCells {
 public:
  explicit RandomCells(ColorDepth depth) : colors_(PaletteColors(depth)) {}

  Cell Next() {
    constexpr char32_t kGlyphs[] = {U' ', U'█',    U'▀',    U'▚',
                                    U'⣿', U'🬗', 0x1CD10, U'a'};
    return {kGlyphs[Below(std::size(kGlyphs))], Color(), Color()};
  }
  std::size_t Below(std::size_t count) { return random_() % count; }

 private:
  Rgb8 Color() {
    if (!colors_.empty()) return colors_[Below(colors_.size())];
    const auto byte = [this] { return static_cast<std::uint8_t>(random_()); };
    return {byte(), byte(), byte()};
  }

  std::span<const Rgb8> colors_;
  std::mt19937 random_{11};
};

class AnsiFrameOf : public testing::TestWithParam<ColorDepth> {};

// A terminal that gets the changes of frame after frame shows the last one.
TEST_P(AnsiFrameOf, ChangesAddUpToTheScreen) {
  const GridSize size{17, 9};
  RandomCells random(GetParam());
  CellGrid grid(size);
  for (Cell& cell : grid.cells) cell = random.Next();
  ScreenDiff diff;
  std::string sent;
  for (int frame = 0; frame < 20; ++frame) {
    for (int i = 0; i < 12; ++i) {
      grid.cells[random.Below(grid.cells.size())] = random.Next();
    }
    if (frame == 10) diff.Invalidate();
    const auto changed = diff.Select(grid, {});
    sent += AnsiFrame(diff.shown(), changed, GetParam());
  }
  const auto shown = ParseAnsi(sent, size);
  ASSERT_TRUE(shown) << shown.error().ToString();
  EXPECT_EQ(Canonical(*shown), Canonical(grid));
}

INSTANTIATE_TEST_SUITE_P(Depths, AnsiFrameOf,
                         testing::Values(ColorDepth::kTruecolor,
                                         ColorDepth::k256, ColorDepth::k16),
                         [](const auto& depth) {
                           return std::string("Colors") + NameOf(depth.param);
                         });

TEST(AnsiFrame, MovesToEachRunOnce) {
  CellGrid grid({4, 2});
  for (Cell& cell : grid.cells) cell = {U'█', {1, 2, 3}, {}};
  EXPECT_EQ(AnsiFrame(grid, std::vector<int>{1, 2, 5}, ColorDepth::kTruecolor),
            "\x1b[1;2H\x1b[38;2;1;2;3m██\x1b[2;2H█");
  EXPECT_EQ(AnsiFrame(grid, std::vector<int>{3, 4}, ColorDepth::kMono),
            "\x1b[1;4H█\x1b[2;1H█");
  EXPECT_EQ(AnsiFrame(grid, {}, ColorDepth::kTruecolor), "");
}

}  // namespace
}  // namespace rtb
