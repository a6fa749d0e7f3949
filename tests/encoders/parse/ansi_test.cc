#include <gtest/gtest.h>

#include "encoders/parse/parse.h"
#include "encoders/parse/terminal_input.h"
#include "tests/encoders/testing.h"

namespace rtb {
namespace {

constexpr Rgb8 kGray{229, 229, 229};  // What nobody colored.

CellGrid Parsed(const std::string& ansi, int columns, int rows) {
  auto grid = ParseAnsi(ansi, {columns, rows});
  EXPECT_TRUE(grid);
  return *grid;
}

TEST(ParseAnsiTest, ReadsTrueColor) {
  const CellGrid grid = Parsed("\x1b[38;2;1;2;3;48;2;4;5;6m▄\x1b[0mx", 2, 1);
  EXPECT_EQ(grid.at(0, 0), (Cell{U'▄', {1, 2, 3}, {4, 5, 6}}));
  EXPECT_EQ(grid.at(1, 0), (Cell{U'x', kGray, {}}));
}

TEST(ParseAnsiTest, ReadsColonSeparatedColors) {
  EXPECT_EQ(Parsed("\x1b[38:2:1:2:3m\x1b[48:5:196mX", 1, 1).at(0, 0),
            (Cell{U'X', {1, 2, 3}, {255, 0, 0}}));
}

// 16 + 36 * 1 + 6 * 2 + 3 = 67 in the cube, 232 the first gray; 1 is red3.
TEST(ParseAnsiTest, ReadsXtermsPalette) {
  const CellGrid grid = Parsed(
      "\x1b[38;5;67;48;5;232mA\x1b[31;44mB\x1b[91;104mC\x1b[38;5;1mD", 4, 1);
  EXPECT_EQ(grid.at(0, 0), (Cell{U'A', {95, 135, 175}, {8, 8, 8}}));
  EXPECT_EQ(grid.at(1, 0), (Cell{U'B', {205, 0, 0}, {0, 0, 238}}));
  EXPECT_EQ(grid.at(2, 0), (Cell{U'C', {255, 0, 0}, {92, 92, 255}}));
  EXPECT_EQ(grid.at(3, 0), (Cell{U'D', {205, 0, 0}, {92, 92, 255}}));
}

TEST(ParseAnsiTest, InverseSwapsTheColors) {
  const CellGrid grid = Parsed("\x1b[7mA\x1b[38;2;9;8;7mB\x1b[27mC", 3, 1);
  EXPECT_EQ(grid.at(0, 0), (Cell{U'A', {}, kGray}));
  EXPECT_EQ(grid.at(1, 0), (Cell{U'B', {}, {9, 8, 7}}));
  EXPECT_EQ(grid.at(2, 0), (Cell{U'C', {9, 8, 7}, {}}));
}

TEST(ParseAnsiTest, CellsNeverWrittenAreBlackSpaces) {
  const CellGrid grid = Canonical(Parsed("", 3, 2));
  for (const Cell& cell : grid.cells) EXPECT_EQ(cell, Cell{});
}

TEST(ParseAnsiTest, FollowsTheCursor) {
  EXPECT_EQ(GlyphText(Parsed("\x1b[2;3HA\x1b[HB\x1b[2CC\x1b[BD", 5, 3)),
            "B  C \n  A D\n     \n");
}

TEST(ParseAnsiTest, ErasedCellsTakeTheBackground) {
  const CellGrid grid = Parsed("\x1b[48;2;1;2;3mA\x1b[K", 2, 1);
  EXPECT_EQ(Canonical(grid).at(1, 0), (Cell{U' ', {}, {1, 2, 3}}));
}

TEST(ParseAnsiTest, WideGlyphsTakeTwoCells) {
  EXPECT_EQ(GlyphText(Parsed("中x", 4, 1)), "中 x \n");
}

TEST(ParseAnsiTest, NewlineReturnsTheCarriage) {
  EXPECT_EQ(GlyphText(Parsed("ab\ncd\r\nef", 3, 3)), "ab \ncd \nef \n");
}

TEST(ParseAnsiTest, TextForALargerGridIsAnError) {
  const auto grid = ParseAnsi("a\nb\nc", {3, 2});
  ASSERT_FALSE(grid.has_value());
  EXPECT_EQ(grid.error().kind, ErrorKind::kBadInput);
  EXPECT_FALSE(ParseAnsi("abcdef\nabcdef", {3, 3}).has_value());
}

// As many lines as rows, each full and ended by LF: nothing scrolls away, even
// when sequences that draw nothing follow.
TEST(ParseAnsiTest, LastNewlineDoesNotScroll) {
  EXPECT_EQ(GlyphText(Parsed("ab\ncd\n", 2, 2)), "ab\ncd\n");
  EXPECT_EQ(GlyphText(Parsed("ab\ncd\x1b[0m\n\x1b[0m\n\x1b[?25h", 2, 2)),
            "ab\ncd\n");
}

TEST(ParseAnsiTest, SurvivesBrokenInput) {
  EXPECT_EQ(GlyphText(Parsed("a\xFF\x1b[38;2;1", 3, 1)), "a\xEF\xBF\xBD \n");
  EXPECT_EQ(GlyphText(Parsed(std::string("a\0b", 3), 3, 1)), "ab \n");
}

TEST(ParseAnsiTest, RefusesEmptyTerminals) {
  EXPECT_FALSE(ParseAnsi("", {0, 1}));
  EXPECT_FALSE(ParseAnsi("", {1, -1}));
}

TEST(TerminalInputTest, AddsCarriageReturnsAndDropsTheLastNewlines) {
  EXPECT_EQ(TerminalInput("a\nb\n\n"), "a\r\nb");
  EXPECT_EQ(TerminalInput("a\x1b[0m\n\x1b[1m"), "a\x1b[0m\x1b[1m");
  EXPECT_EQ(TerminalInput("a\n\x1b[2J"), "a\r\n\x1b[2J");
  EXPECT_EQ(TerminalInput("a\n\x1b["), "a\r\n\x1b[");
  EXPECT_EQ(TerminalInput(""), "");
}

}  // namespace
}  // namespace rtb
