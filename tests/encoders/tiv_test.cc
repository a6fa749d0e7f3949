#include <gtest/gtest.h>

#include "core/image/io.h"
#include "encoders/parse/parse.h"
#include "tests/encoders/testing.h"

namespace rtb {
namespace {

constexpr Rgb8 kBlack{0, 0, 0};
constexpr Rgb8 kWhite{255, 255, 255};

/// Encodes a drawing of 8 lines of 4 characters.
Cell EncodeDrawn(const std::string& picture,
                 const std::map<char, Rgb8>& legend) {
  return EncodeOne("tiv", Drawn(picture, legend));
}

/// 'A' + i is the gray 2 * i, '.' black, '#' white.
std::map<char, Rgb8> Grays() {
  std::map<char, Rgb8> legend = {{'.', kBlack}, {'#', kWhite}};
  for (char c = 'A'; c <= 'Z'; ++c) {
    const auto gray = static_cast<std::uint8_t>(2 * (c - 'A' + 1));
    legend[c] = {gray, gray, gray};
  }
  return legend;
}

/// Encodes 4 x 8 pixels a cell.
CellGrid EncodeImage(const Image& image) {
  const GridSize size{image.width() / 4, image.height() / 8};
  std::vector<Rgb> values(image.pixels().size(), Rgb(0));
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const int cell = y / 8 * size.columns + x / 4;
      const int sample = y % 8 * 4 + x % 4;
      values[static_cast<std::size_t>(cell * 32 + sample)] = image.at(x, y);
    }
  }
  return EncodeValues("tiv", size, std::move(values));
}

class TivPictureTest : public testing::TestWithParam<const char*> {};

TEST_P(TivPictureTest, EveryCellIsWhatTheProgramPrinted) {
  const std::string base = std::string("data/tiv/") + GetParam();
  const auto image =
      ReadLinear(std::string(RTB_TEST_SOURCE_DIR) + "/tests/" + base + ".png");
  ASSERT_TRUE(image) << image.error().ToString();
  const auto expected =
      ParseCellsJson(ReadTestFile(base + ".tiv.json"), GetParam());
  ASSERT_TRUE(expected) << expected.error().ToString();
  const CellGrid grid = Canonical(EncodeImage(*image));
  const CellGrid printed = Canonical(*expected);
  ASSERT_EQ(grid.size, printed.size);
  int different = 0;
  for (std::size_t i = 0; i < grid.cells.size(); ++i) {
    if (grid.cells[i] != printed.cells[i]) ++different;
  }
  EXPECT_EQ(different, 0);
}

INSTANTIATE_TEST_SUITE_P(, TivPictureTest,
                         testing::Values("gradient", "spheres", "synthetic"),
                         [](const auto& test) {
                           return std::string(test.param);
                         });

TEST(TivTest, OneColorIsANoBreakSpace) {
  const Rgb8 color{1, 2, 3};
  EXPECT_EQ(EncodeOne("tiv", std::vector<Rgb8>(32, color)),
            (Cell{U'\u00A0', color, color}));
}

// 9 black and 8 white pixels are more than half of 32: direct. Set are the
// pixels nearer to white (the second color), the lower half.
TEST(TivTest, SeventeenPixelsOfTwoColorsAreDirect) {
  auto legend = Grays();
  legend['X'] = {250, 250, 250};
  legend['Y'] = {249, 249, 249};
  EXPECT_EQ(EncodeDrawn("....\n....\n.ABC\nDEFG\n"
                        "XXXX\nYYYY\n####\n####\n",
                        legend),
            (Cell{U'▄', kWhite, kBlack}));
}

// 8 white and 8 black pixels are not: the channels' range decides. All are
// gray, so red is split at 0 + 255 / 2 = 127, into the same halves. Below:
// (4 * 250 + 4 * 249 + 8 * 255) / 16 = 252.25; above: grays 2 .. 16 on 8 pixels
// and black, 72 / 16 = 4.5. Both are truncated.
TEST(TivTest, SixteenPixelsOfTwoColorsAreNotDirect) {
  auto legend = Grays();
  legend['X'] = {250, 250, 250};
  legend['Y'] = {249, 249, 249};
  EXPECT_EQ(EncodeDrawn("....\n....\nABCD\nEFGH\n"
                        "XXXX\nYYYY\n####\n####\n",
                        legend),
            (Cell{U'▄', {252, 252, 252}, {4, 4, 4}}));
}

// 16 pixels each: white, the larger 0xRRGGBB, counts as the first color. Set
// are the pixels nearer to black, which is the complement of U+2584's pattern,
// so that the colors are swapped: white below.
TEST(TivTest, LargerColorIsFirstAmongEquals) {
  EXPECT_EQ(
      EncodeDrawn("....\n....\n....\n....\n####\n####\n####\n####\n", Grays()),
      (Cell{U'▄', kWhite, kBlack}));
  EXPECT_EQ(
      EncodeDrawn("####\n####\n####\n####\n....\n....\n....\n....\n", Grays()),
      (Cell{U'▄', kBlack, kWhite}));
}

// No pattern comes within 7 of a checkerboard: U+2584 as it stands, though its
// distance is 16. White is the first color and hence the background.
TEST(TivTest, LowerHalfBlockWhenNothingIsNear) {
  EXPECT_EQ(
      EncodeDrawn("#.#.\n.#.#\n#.#.\n.#.#\n#.#.\n.#.#\n#.#.\n.#.#\n", Grays()),
      (Cell{U'▄', kBlack, kWhite}));
}

// One bright pixel among 31 different dark grays: the bitmap is one bit away
// from the empty pattern, which sets no pixel: the foreground is black. The
// background is the truncated mean of all: (0 + 1 + .. + 30 + 255) / 32 =
// 720 / 32 = 22.5.
TEST(TivTest, ForegroundIsBlackWhenThePatternIsEmpty) {
  std::vector<Rgb8> pixels = {kWhite};
  for (std::uint8_t i = 0; i < 31; ++i) pixels.push_back({i, i, i});
  EXPECT_EQ(EncodeOne("tiv", pixels), (Cell{U'\u00A0', {}, {22, 22, 22}}));
}

// 32 colors; red and green both range over 240, and red, the first, is high
// in the upper half. That is the complement of U+2584's pattern; the colors
// are those under the pattern itself: below as foreground. (Green alternates
// by column and would give stripes.)
TEST(TivTest, RangeTakesTheFirstOfEqualChannelsAndThePatternsColors) {
  std::vector<Rgb8> pixels;
  for (std::uint8_t i = 0; i < 32; ++i) {
    pixels.push_back({static_cast<std::uint8_t>(i < 16 ? 240 : 0),
                      static_cast<std::uint8_t>(i % 2 * 240), i});
  }
  // Blue: 16 .. 31 has mean 23.5, 0 .. 15 has 7.5.
  EXPECT_EQ(EncodeOne("tiv", pixels),
            (Cell{U'▄', {0, 120, 23}, {240, 120, 7}}));
}

// Split = min + range / 2 in integers: 10 + 5 / 2 = 12, and 12 is not greater.
TEST(TivTest, SplitIsTruncated) {
  std::vector<Rgb8> pixels;
  for (std::uint8_t i = 0; i < 32; ++i) {
    // Red 10, 12 (upper half), 13, 15 (lower half); 4 equal pixels at most.
    const int red = (i < 16 ? 10 : 13) + i % 2 * 2;
    pixels.push_back({static_cast<std::uint8_t>(red),
                      static_cast<std::uint8_t>(i / 2 % 4),
                      static_cast<std::uint8_t>(i / 8 % 2)});
  }
  const Cell cell = EncodeOne("tiv", pixels);
  EXPECT_EQ(cell.glyph, U'▄');
  EXPECT_EQ(cell.fg.r, 14);  // (13 + 15) / 2.
  EXPECT_EQ(cell.bg.r, 11);  // (10 + 12) / 2.
}

}  // namespace
}  // namespace rtb
