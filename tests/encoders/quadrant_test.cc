#include <gtest/gtest.h>

#include "encoders/blend.h"
#include "encoders/glyphs/patterns.h"
#include "tests/encoders/testing.h"

namespace rtb {
namespace {

Rgb8 Gray(int code) {
  const auto gray = static_cast<std::uint8_t>(code);
  return {gray, gray, gray};
}

class QuadrantSplitTest : public testing::TestWithParam<const char*> {};

// Cell p has white where bit p of the pattern is set (bit 0 = top left), black
// elsewhere. All and none are spaces: no quadrant is above the mean.
TEST_P(QuadrantSplitTest, DrawsAllSixteenPatterns) {
  std::vector<std::vector<int>> codes;
  for (int pattern = 0; pattern < 16; ++pattern) {
    std::vector<int>& cell = codes.emplace_back();
    for (int i = 0; i < 4; ++i) cell.push_back((pattern >> i & 1) * 255);
  }
  const CellGrid grid = EncodeValues(
      std::string("quadrant:split=") + GetParam(), {16, 1}, GrayValues(codes));
  EXPECT_EQ(GlyphText(grid), " ▘▝▀▖▌▞▛▗▚▐▜▄▙▟ \n");
  EXPECT_EQ(grid.cells[0], (Cell{U' ', {}, Gray(0)}));
  EXPECT_EQ(grid.cells[15], (Cell{U' ', {}, Gray(255)}));
  for (std::size_t i = 1; i < 15; ++i) {
    EXPECT_EQ(grid.cells[i].fg, Gray(255)) << i;
    EXPECT_EQ(grid.cells[i].bg, Gray(0)) << i;
  }
}

INSTANTIATE_TEST_SUITE_P(, QuadrantSplitTest,
                         testing::Values("brightness", "range", "best"),
                         [](const auto& test) {
                           return std::string(test.param);
                         });

// Brightness of a gray is its value: the mean of 0, 128, 255 and 129 is 128,
// and 128 is not greater. Means: (255 + 129) / 2 and (0 + 128) / 2.
TEST(QuadrantTest, BrightnessEqualToTheMeanIsOff) {
  EXPECT_EQ(EncodeOneGray("quadrant", {0, 128, 255, 129}),
            (Cell{U'▄', Gray(192), Gray(64)}));
}

// Mean 65.75; on are 130 and 131, mean 130.5; off 0 and 2, mean 1.
// 10 and 11 in the dark: mean 10.5.
TEST(QuadrantTest, MeansAreRoundedHalfUp) {
  EXPECT_EQ(EncodeOneGray("quadrant", {0, 130, 2, 131}),
            (Cell{U'▐', Gray(131), Gray(1)}));
  EXPECT_EQ(EncodeOneGray("quadrant", {10, 130, 11, 131}),
            (Cell{U'▐', Gray(131), Gray(11)}));
}

// The mean of neighboring codes is k + 0.5, whatever single precision makes of
// the way to linear light and back. On are the two whites.
TEST(QuadrantTest, EveryMeanOfNeighboringCodesIsRoundedUp) {
  for (int code = 0; code < 254; ++code) {
    EXPECT_EQ(EncodeOneGray("quadrant", {code, 255, code + 1, 255}),
              (Cell{U'▐', Gray(255), Gray(code + 1)}));
  }
}

// HSP: red 255 sqrt(0.299) = 139, green 255 sqrt(0.587) = 195, blue 255
// sqrt(0.114) = 86; mean of red, green, blue and black 105.
TEST(QuadrantTest, BrightnessWeighsTheChannels) {
  EXPECT_EQ(
      EncodeOne("quadrant", {{255, 0, 0}, {0, 255, 0}, {0, 0, 255}, {0, 0, 0}}),
      (Cell{U'▀', {128, 128, 0}, {0, 0, 128}}));
}

// Background = mean of black and code 100, foreground white.
// srgb: 50. linear: l(100) = 0.12744, half of it encodes to 71.4. oklab: the
// root of l is halved, l / 8 = 0.01593 encodes to 33.9.
TEST(QuadrantTest, BlendsInTheSpaceItIsTold) {
  const std::vector<int> codes = {0, 100, 255, 255};
  EXPECT_EQ(EncodeOneGray("quadrant", codes),
            (Cell{U'▄', Gray(255), Gray(50)}));
  EXPECT_EQ(EncodeOneGray("quadrant:blend=linear", codes),
            (Cell{U'▄', Gray(255), Gray(71)}));
  EXPECT_EQ(EncodeOneGray("quadrant:blend=oklab", codes),
            (Cell{U'▄', Gray(255), Gray(34)}));
}

// Blue has the largest range (200 against 100 and 150) and is high at the top;
// but HSP of (0, 0, 200) is 68, of (100, 150, 0) 127: the foreground is below.
TEST(QuadrantTest, RangeTakesTheWidestChannelAndTheBrighterSide) {
  const Rgb8 blue{0, 0, 200};
  const Rgb8 olive{100, 150, 0};
  EXPECT_EQ(EncodeOne("quadrant:split=range", {blue, blue, olive, olive}),
            (Cell{U'▄', olive, blue}));
}

// Red and green both range over 100; red, the first, splits left from right.
// Left (100, 50, 0) in the mean, right (0, 50, 0): left is brighter.
TEST(QuadrantTest, RangeTakesTheFirstOfEqualChannels) {
  EXPECT_EQ(EncodeOne("quadrant:split=range",
                      {{100, 100, 0}, {0, 100, 0}, {100, 0, 0}, {0, 0, 0}}),
            (Cell{U'▌', {100, 50, 0}, {0, 50, 0}}));
}

// The middle of 0 .. 200 is 100, and 100 is not greater.
TEST(QuadrantTest, RangeLeavesTheMiddleOff) {
  EXPECT_EQ(EncodeOneGray("quadrant:split=range", {0, 100, 100, 200}),
            (Cell{U'▗', Gray(200), Gray(67)}));
}

// {0} | {100, 100, 200} and {0, 100, 100} | {200} have the same squared error
// (2 * 33.3^2 + 66.7^2 = 6667; the even splits have 10000). As masks the first
// is 0001, the second 0111: the lower one wins.
TEST(QuadrantTest, BestTakesTheLowerOfEqualPartitions) {
  EXPECT_EQ(EncodeOneGray("quadrant:split=best", {0, 100, 100, 200}),
            (Cell{U'▟', Gray(133), Gray(0)}));
}

// The same for every step: exact ties of 8-bit codes are ties.
TEST(QuadrantTest, BestSeesEveryTieOfCodes) {
  for (int step = 1; step <= 100; ++step) {
    for (const int low : {0, 7, 55}) {
      EXPECT_EQ(EncodeOneGray("quadrant:split=best",
                              {low, low + step, low + step, low + 2 * step})
                    .glyph,
                U'▟')
          << low << " " << step;
    }
  }
}

// 299 * 65^2 + 114 * 180^2 = 299 * 125^2 + 114 * 50^2, and green is the same:
// both colors have one HSP brightness, so the lower mask (0011) is on.
TEST(QuadrantTest, LowerMaskIsOnWhenBothSidesAreEquallyBright) {
  const Rgb8 violet{65, 10, 180};
  const Rgb8 red{125, 10, 50};
  EXPECT_EQ(EncodeOne("quadrant:split=best", {violet, violet, red, red}),
            (Cell{U'▀', violet, red}));
  EXPECT_EQ(EncodeOne("quadrant:split=range", {red, red, violet, violet}),
            (Cell{U'▀', red, violet}));
}

class QuadrantBlendTest : public testing::TestWithParam<const char*> {};

TEST_P(QuadrantBlendTest, BestIsTheBestOfAllSixteen) {
  ExpectBestPartitions(std::string("quadrant:split=best:blend=") + GetParam(),
                       4, *ReadBlend({{"blend", GetParam()}}), QuadrantGlyph);
}

INSTANTIATE_TEST_SUITE_P(, QuadrantBlendTest,
                         testing::Values("srgb", "linear", "oklab"),
                         [](const auto& test) {
                           return std::string(test.param);
                         });

}  // namespace
}  // namespace rtb
