#include <gtest/gtest.h>

#include <utility>

#include "core/math/random.h"
#include "encoders/parse/glyph_text.h"
#include "encoders/parse/parse.h"
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
  for (const char* form :
       {"38:2:1:2:3", "38:2::1:2:3", "38:2:0:1:2:3", "38:2::1:2:3:0:1"}) {
    EXPECT_EQ(
        Parsed(std::string("\x1b[") + form + ";48:5:196mX", 1, 1).at(0, 0),
        (Cell{U'X', {1, 2, 3}, {255, 0, 0}}))
        << form;
  }
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

// xterm 379 draws SGR 2 with two thirds of each component, in 16 bits: 1 of 2
// (514 -> 342, whose upper byte is 1), 137 of 205 (52685 -> 35123).
TEST(ParseAnsiTest, ReadsWhatHidesAndDims) {
  const CellGrid grid =
      Parsed("\x1b[38;2;2;205;0mA\x1b[8mB\x1b[28mC\x1b[2mD\x1b[22mE", 5, 1);
  EXPECT_EQ(GlyphText(grid), "A CDE\n");
  EXPECT_EQ(grid.at(2, 0).fg, (Rgb8{2, 205, 0}));
  EXPECT_EQ(grid.at(3, 0).fg, (Rgb8{1, 137, 0}));
  EXPECT_EQ(grid.at(4, 0).fg, (Rgb8{2, 205, 0}));
}

TEST(ParseAnsiTest, BoldIsNotBrightAndBlinkingIsNothing) {
  const CellGrid grid =
      Parsed("\x1b[1;31mA\x1b[0;5;31mB\x1b[0;3;4;9;31mC", 3, 1);
  for (const Cell& cell : grid.cells) {
    EXPECT_EQ(cell.fg, (Rgb8{205, 0, 0}));
    EXPECT_EQ(cell.bg, Rgb8{});
  }
}

TEST(ParseAnsiTest, ReversesTheWholeScreen) {
  const CellGrid grid = Parsed("A\x1b[7mB\x1b[?5h", 3, 1);
  EXPECT_EQ(grid.at(0, 0), (Cell{U'A', {}, kGray}));
  EXPECT_EQ(grid.at(1, 0), (Cell{U'B', kGray, {}}));
  EXPECT_EQ(grid.at(2, 0).bg, kGray);
}

TEST(ParseAnsiTest, RepeatsCharacters) {
  EXPECT_EQ(GlyphText(Parsed("▄\x1b[2bx\x1b[b", 6, 1)), "▄▄▄xx \n");
  EXPECT_EQ(GlyphText(Parsed("\x1b[9ba", 3, 1)), "a  \n");
}

TEST(ParseAnsiTest, ErasesCharactersInTheBackground) {
  const CellGrid grid = Parsed("abcd\x1b[48;2;1;2;3m\x1b[2G\x1b[2X", 4, 1);
  EXPECT_EQ(GlyphText(grid), "a  d\n");
  EXPECT_EQ(grid.at(1, 0).bg, (Rgb8{1, 2, 3}));
  EXPECT_EQ(grid.at(2, 0).bg, (Rgb8{1, 2, 3}));
  EXPECT_EQ(grid.at(3, 0).bg, Rgb8{});
}

TEST(ParseAnsiTest, MovesToTabStops) {
  EXPECT_EQ(GlyphText(Parsed("\ta\r\t\tb", 18, 1)), "        a       b \n");
}

// A character in the last column leaves the cursor there; the next goes to the
// next line, but a carriage return goes back in this one.
TEST(ParseAnsiTest, WrapsWhenTheNextCharacterComes) {
  EXPECT_EQ(GlyphText(Parsed("abc\x1b[31m", 3, 2)), "abc\n   \n");
  EXPECT_EQ(GlyphText(Parsed("abc\x1b[31md", 3, 2)), "abc\nd  \n");
  EXPECT_EQ(GlyphText(Parsed("abc\rd", 3, 2)), "dbc\n   \n");
  EXPECT_EQ(GlyphText(Parsed("abc\r\nd", 3, 2)), "abc\nd  \n");
  EXPECT_EQ(GlyphText(Parsed("ab中x", 3, 2)), "ab \n中 x\n");
}

TEST(ParseAnsiTest, KeepsTheFirstOfCombinedCharacters) {
  EXPECT_EQ(GlyphText(Parsed("e\xCC\x81x", 2, 1)), "ex\n");
}

TEST(ParseAnsiTest, ReadsGlyphsOfFourBytes) {
  EXPECT_EQ(GlyphText(Parsed("\U0001FB00\U0001CD00x", 3, 1)),
            "\U0001FB00\U0001CD00x\n");
}

// A full-screen program's picture, whether it leaves the alternate screen at
// its end or not; what it leaves in the middle is gone.
TEST(ParseAnsiTest, ReadsTheAlternateScreen) {
  const std::string enter = "xx\x1b[?1049h\x1b[H";
  EXPECT_EQ(GlyphText(Parsed(enter + "ab", 3, 1)), "ab \n");
  EXPECT_EQ(GlyphText(Parsed(enter + "ab\x1b[?25h\x1b[?1049l", 3, 1)), "ab \n");
  EXPECT_EQ(GlyphText(Parsed(enter + "ab\x1b[?1049ly", 3, 1)), "xxy\n");
  EXPECT_FALSE(ParseAnsi(enter + "a\nb\nc", {3, 2}));
}

TEST(ParseAnsiTest, LeavesOutStrings) {
  EXPECT_EQ(GlyphText(Parsed("a\x1b]0;title\ab\x1b]8;;x\x1b\\c\x1b^no\x1b\\"
                             "\x1b_no\x1b\\d\x1bPno\x1b\\e\x1bXno\x1b\\f",
                             7, 1)),
            "abcdef \n");
}

TEST(ParseAnsiTest, RefusesGraphics) {
  for (const auto& [name, text] :
       {std::pair{"sixel", "ab\x1bP0;1;0q#0!10~\x1b\\"},
        std::pair{"kitty", "\x1b_Ga=T,f=24;AAAA\x1b\\"},
        std::pair{"iTerm2", "\x1b]1337;File=inline=1:AAAA\a"}}) {
    const auto grid = ParseAnsi(text, {4, 4});
    ASSERT_FALSE(grid.has_value()) << name;
    EXPECT_EQ(grid.error().kind, ErrorKind::kBadInput);
    EXPECT_NE(grid.error().what.find(name), std::string::npos);
    EXPECT_FALSE(grid.error().hint.empty());
  }
}

// More parameters than libvterm 0.1.4 has room for, which made it crash, and
// counts that made it hang.
TEST(ParseAnsiTest, SurvivesLongAndLargeParameters) {
  std::string zeros = "0";
  for (int i = 0; i < 40; ++i) zeros += ";0";
  const CellGrid grid =
      Parsed("\x1b[" + zeros + ";38;2;9;8;7;48;2;4;5;6mA", 1, 1);
  EXPECT_EQ(grid.at(0, 0), (Cell{U'A', {9, 8, 7}, {4, 5, 6}}));
  for (const char final : std::string("@ABCDEFGHJKLMPSTXbdhlrsu")) {
    for (const std::string& number :
         {zeros, std::string("2147483647"), std::string("99999999999999")}) {
      const auto parsed = ParseAnsi("\x1b[" + number + final, {3, 2});
      EXPECT_TRUE(parsed ||
                  parsed.error().what.find("scrolled") != std::string::npos)
          << final;
    }
  }
}

// Whatever bytes come, there is a grid or an error. The alphabet favors what
// sequences are made of.
TEST(ParseAnsiTest, SurvivesAnyBytes) {
  const std::string alphabet =
      "\x1b\x1b\x1b[[[;;:0123489?>!$ \"#mmHJKbXhlrPq\\]_G\n\r\t\a\x18z\xE2\x96"
      "\x84\xF0\xCC\xFF";
  for (std::uint32_t text = 0; text < 3000; ++text) {
    std::string bytes;
    for (std::uint32_t i = 0; i < 60; ++i) {
      bytes += alphabet[RandomBits(text, i, 0, 0) % alphabet.size()];
    }
    const auto grid = ParseAnsi(bytes, {5, 3});
    if (!grid) continue;
    for (const Cell& cell : grid->cells) ASSERT_TRUE(IsGlyph(cell.glyph));
  }
}

// Several megabytes in one piece were too much for libvterm's stack.
TEST(ParseAnsiTest, ReadsLongOutput) {
  std::string text;
  for (int i = 0; i < 400000; ++i) text += "\x1b[1;1Ha\x1b[2;2H▀";
  text += "\x1b[1;1Hz";
  const auto grid = ParseAnsi(text, {3, 2});
  ASSERT_TRUE(grid);
  EXPECT_EQ(grid->at(0, 0).glyph, U'z');
  EXPECT_EQ(grid->at(1, 1).glyph, U'▀');
}

}  // namespace
}  // namespace rtb
