#include "harness/live/layout.h"

#include <gtest/gtest.h>

namespace rtb {
namespace {

TEST(Layout, PanelIsBesideThePictureWhereThereIsRoom) {
  const Layout layout = MakeLayout({120, 40}, true);
  EXPECT_EQ(layout.picture.columns, 86);
  EXPECT_EQ(layout.picture.rows, 40);
  EXPECT_EQ(layout.panel.column, 86);
  EXPECT_EQ(layout.panel.columns, 34);
  EXPECT_EQ(layout.status.rows, 0);
}

TEST(Layout, ASmallTerminalHasAStatusLine) {
  const Layout layout = MakeLayout({40, 12}, true);
  EXPECT_EQ(layout.picture.rows, 11);
  EXPECT_EQ(layout.status.row, 11);
  EXPECT_EQ(layout.panel.columns, 0);
}

TEST(Layout, EverySizeLeavesAPicture) {
  for (int columns = 1; columns <= 400; columns += 7) {
    for (int rows = 1; rows <= 120; rows += 3) {
      for (const bool panel : {false, true}) {
        const Layout layout = MakeLayout({columns, rows}, panel);
        EXPECT_GE(layout.picture.columns, 1);
        EXPECT_GE(layout.picture.rows, 1);
        EXPECT_EQ(layout.picture.columns + layout.panel.columns, columns);
        EXPECT_EQ(layout.picture.rows + layout.status.rows, rows);
      }
    }
  }
}

TEST(Text, ControlCharactersBecomeQuestionMarks) {
  EXPECT_EQ(Glyphs("a\x1b[2J\x07\xC2\x9B"), U"a?[2J???");
  EXPECT_EQ(Glyphs("é▀"), U"é▀");
  EXPECT_EQ(Glyphs("\xFF\xFE"), U"??");
  EXPECT_EQ(Glyphs("漢"), U"?");  // Two columns wide.
}

TEST(Text, IsCutAtEveryBorder) {
  CellGrid grid({4, 2});
  const TextColors colors{{9, 9, 9}, {1, 1, 1}};
  DrawText({1, 0, 2, 1}, 0, 0, U"abcdef", colors, &grid);
  DrawText({3, 1, 9, 9}, 0, 0, U"xyz", colors, &grid);
  DrawText({0, 0, 4, 2}, 0, 7, U"no", colors, &grid);
  FillRect({-3, -3, 2, 2}, {}, &grid);
  std::u32string text;
  for (const Cell& cell : grid.cells) text += cell.glyph;
  EXPECT_EQ(text, U" ab    x");
}

}  // namespace
}  // namespace rtb
