#include <gtest/gtest.h>

#include <random>

#include "encoders/palette.h"
#include "encoders/parse/parse.h"
#include "harness/live/live_setup.h"
#include "harness/live/pair_pool.h"
#include "harness/live/screen_diff.h"

namespace rtb {
namespace {

TEST(PairPool, SharesPairsAndCountsThem) {
  PairPool pool(2);
  const auto first = pool.Acquire({1, 2});
  const auto again = pool.Acquire({1, 2});
  const auto second = pool.Acquire({3, 2});
  ASSERT_TRUE(first && again && second);
  EXPECT_TRUE(first->is_new);
  EXPECT_FALSE(again->is_new);
  EXPECT_EQ(first->pair, again->pair);
  EXPECT_NE(first->pair, second->pair);
  EXPECT_FALSE(pool.Acquire({9, 9}));
  EXPECT_EQ(pool.Substitute({9, 2}) == 0, false);
}

TEST(PairPool, APairIsFreeWhenTheLastCellHasLeftTheScreen) {
  PairPool pool(1);
  const int pair = pool.Acquire({1, 2})->pair;
  pool.Acquire({1, 2});
  pool.Release(pair);
  pool.Settle();
  EXPECT_FALSE(pool.Acquire({5, 5}));
  pool.Release(pair);
  EXPECT_FALSE(pool.Acquire({5, 5}));  // The screen still shows it.
  pool.Settle();
  EXPECT_EQ(pool.used(), 0);
  EXPECT_TRUE(pool.Acquire({5, 5})->is_new);
}

class NcursesPresenterTest : public testing::Test {
 protected:
  void SetUp() override { UseUtf8Locale(); }

  /// What a terminal shows after `frames` frames of random cells, and what it
  /// should.
  void Compare(const std::string& term, ColorDepth depth, int frames,
               std::span<const Rgb8> colors) {
    const GridSize size{40, 20};
    auto presenter = MakeNcursesPresenter(term, depth, size);
    if (!presenter) GTEST_SKIP() << presenter.error().ToString();
    std::mt19937 random(3);
    const auto color = [&] {
      if (!colors.empty()) return colors[random() % colors.size()];
      const auto byte = [&] {
        // From 8 on: smaller blues mean the palette in these entries.
        return static_cast<std::uint8_t>(8 + random() % 248);
      };
      return Rgb8{byte(), byte(), byte()};
    };
    constexpr char32_t kGlyphs[] = {U' ', U'▀', U'▌', U'▚', U'█', U'⣿'};
    CellGrid grid(size);
    ScreenDiff diff;
    std::string sent;
    for (int frame = 0; frame < frames; ++frame) {
      for (Cell& cell : grid.cells) {
        if (frame > 0 && random() % 4 == 0) continue;
        cell = {kGlyphs[random() % std::size(kGlyphs)], color(), color()};
      }
      const auto changed = diff.Select(grid, {});
      auto bytes = (*presenter)->Draw({diff.shown(), changed, diff.cleared()});
      ASSERT_TRUE(bytes.has_value());
      sent += *bytes;
    }
    const auto shown = ParseAnsi(sent, size);
    ASSERT_TRUE(shown.has_value()) << shown.error().ToString();
    // Cells that look alike are not sent: a full block for a space, say.
    AppearanceTable table;
    for (std::size_t i = 0; i < grid.cells.size(); ++i) {
      EXPECT_EQ(table.Difference(shown->cells[i], grid.cells[i]), 0) << i;
    }
  }
};

// 120 frames of 800 cells: more than 70,000 pairs of colors.
TEST_F(NcursesPresenterTest, TruecolorStaysRightOverManyPairs) {
  Compare("xterm-256color", ColorDepth::kTruecolor, 120, {});
}

TEST_F(NcursesPresenterTest, Palette256) {
  Compare("xterm-256color", ColorDepth::k256, 20,
          PaletteColors(ColorDepth::k256));
}

TEST_F(NcursesPresenterTest, Palette16) {
  Compare("xterm-16color", ColorDepth::k16, 20, PaletteColors(ColorDepth::k16));
}

TEST_F(NcursesPresenterTest, ResizesAndRefusesUnknownTerminals) {
  EXPECT_FALSE(
      MakeNcursesPresenter("no-such-terminal", ColorDepth::k256, {10, 5}));
  auto presenter =
      MakeNcursesPresenter("xterm-256color", ColorDepth::k256, {10, 5});
  if (!presenter) GTEST_SKIP() << presenter.error().ToString();
  const auto colors = PaletteColors(ColorDepth::k256);
  for (const GridSize size :
       {GridSize{30, 12}, GridSize{1, 1}, GridSize{100, 40}, GridSize{7, 3}}) {
    CellGrid grid(size);
    for (std::size_t i = 0; i < grid.cells.size(); ++i) {
      grid.cells[i] = {U'▀', colors[i % 240], colors[(i * 7) % 240]};
    }
    ScreenDiff diff;
    const auto changed = diff.Select(grid, {});
    const auto bytes = (*presenter)->Draw({grid, changed, true});
    ASSERT_TRUE(bytes.has_value());
    const auto shown = ParseAnsi(*bytes, size);
    ASSERT_TRUE(shown.has_value()) << shown.error().ToString();
    EXPECT_EQ(Canonical(*shown), Canonical(grid)) << size.columns;
  }
}

}  // namespace
}  // namespace rtb
