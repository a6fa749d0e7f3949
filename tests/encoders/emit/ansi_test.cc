#include <gtest/gtest.h>

#include "encoders/emit/emit.h"
#include "encoders/palette.h"
#include "tests/encoders/testing.h"

namespace rtb {
namespace {

constexpr Rgb8 kRed{255, 0, 0};
constexpr Rgb8 kBlue{0, 0, 255};

TEST(EmitAnsiTest, SetsBothColorsInOneSequence) {
  EXPECT_EQ(EmitAnsi(Row({{U'▄', {1, 2, 3}, {4, 5, 6}}})),
            "\x1b[38;2;1;2;3;48;2;4;5;6m▄\x1b[m\n");
}

TEST(EmitAnsiTest, NamesChangedColorsOnly) {
  EXPECT_EQ(EmitAnsi(Row({{U'▄', kRed, kBlue},
                          {U'▀', kRed, kBlue},
                          {U'▄', kRed, kRed},
                          {U'▄', kBlue, kRed}})),
            "\x1b[38;2;255;0;0;48;2;0;0;255m▄▀\x1b[48;2;255;0;0m▄"
            "\x1b[38;2;0;0;255m▄\x1b[m\n");
}

// A space shows no foreground, a full block no background: not even a color
// that no palette holds matters there.
TEST(EmitAnsiTest, LeavesOutColorsThatDoNotShow) {
  const Rgb8 other{1, 2, 3};
  for (const char32_t space : {char32_t{U' '}, kNoBreakSpace}) {
    EXPECT_EQ(EmitAnsi(Row({{space, other, XtermColor(21)}}), ColorDepth::k256),
              "\x1b[48;5;21m" + Utf8(space) + "\x1b[m\n");
  }
  EXPECT_EQ(EmitAnsi(Row({{U'█', kRed, other}, {U'█', kRed, kBlue}})),
            "\x1b[38;2;255;0;0m██\x1b[m\n");
}

// The space needs a new background, the half block after it a new foreground
// alone: one sequence sets both. The last space's foreground is nobody's.
TEST(EmitAnsiTest, BringsAlongTheColorThatShowsNext) {
  EXPECT_EQ(EmitAnsi(Row({{U' ', kBlue, kBlue},
                          {U' ', kBlue, kBlue},
                          {U'▄', kRed, kBlue},
                          {U' ', kBlue, kRed}})),
            "\x1b[38;2;255;0;0;48;2;0;0;255m  ▄\x1b[48;2;255;0;0m \x1b[m\n");
}

TEST(EmitAnsiTest, StartsEveryRowAfresh) {
  CellGrid grid({1, 2});
  grid.cells = {{U' ', {}, kBlue}, {U' ', {}, kBlue}};
  EXPECT_EQ(EmitAnsi(grid),
            "\x1b[48;2;0;0;255m \x1b[m\n\x1b[48;2;0;0;255m \x1b[m\n");
}

// 16 + 36 * 1 + 6 * 2 + 3 = 67 in the cube; 232 is the first gray. Black is
// 16, since 0 differs between terminals.
TEST(EmitAnsiTest, NamesIndicesOf256) {
  EXPECT_EQ(EmitAnsi(Row({{U'▄', {95, 135, 175}, {8, 8, 8}},
                          {U'▄', {0, 0, 0}, {8, 8, 8}}}),
                     ColorDepth::k256),
            "\x1b[38;5;67;48;5;232m▄\x1b[38;5;16m▄\x1b[m\n");
}

// 205 red is color 1, 92 blue color 12, 0 black color 0.
TEST(EmitAnsiTest, NamesSixteenColorsInTheirOwnCodes) {
  EXPECT_EQ(EmitAnsi(Row({{U'▄', {205, 0, 0}, {92, 92, 255}},
                          {U'▄', {92, 92, 255}, {}}}),
                     ColorDepth::k16),
            "\x1b[31;104m▄\x1b[94;40m▄\x1b[m\n");
}

TEST(EmitAnsiTest, MonoIsPlainText) {
  EXPECT_EQ(
      EmitAnsi(Row({{U'▄', kRed, kBlue}, {U' ', {}, {}}}), ColorDepth::kMono),
      "▄ \n");
}

TEST(EmitAnsiDeathTest, ColorsOutsideThePaletteAreABug) {
  EXPECT_DEATH(EmitAnsi(Row({{U'▄', {1, 2, 3}, {}}}), ColorDepth::k16),
               "index");
}

}  // namespace
}  // namespace rtb
