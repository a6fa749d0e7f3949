// What programs printed (tests/data/ansi/README.md says which and how), against
// the pixels that they were given: the cells are half blocks of two pixels.
#include <gtest/gtest.h>

#include <functional>
#include <ostream>

#include "core/color/srgb.h"
#include "encoders/decode.h"
#include "encoders/palette.h"
#include "encoders/parse/parse.h"
#include "tests/encoders/testing.h"

namespace rtb {
namespace {

constexpr GridSize kGrid{6, 4};

using Pixels = std::function<Rgb8(int x, int y)>;

/// The cube's levels, all of them exact in 256 colors.
Rgb8 CubePixel(int x, int y) {
  const std::uint8_t levels[] = {0, 95, 135, 175, 215, 255};
  return {levels[x], levels[(x + 2 * y) % 6], levels[(3 * x + y) % 6]};
}

/// Black and the bright ANSI colors, as xterm defines them.
Rgb8 BrightPixel(int x, int y) {
  const int code = (3 * x + 5 * y + x * y) % 8;
  return code == 0 ? Rgb8{} : XtermColor(8 + code);
}

Rgb8 BlackOrWhitePixel(int x, int y) {
  return (x * (y / 2) + y) % 2 == 0 ? kDefaultBackground : kDefaultForeground;
}

struct Output {
  const char* name;
  Pixels pixels;
};

void PrintTo(const Output& output, std::ostream* out) { *out << output.name; }

class ProgramOutputTest : public testing::TestWithParam<Output> {};

TEST_P(ProgramOutputTest, ShowsThePixels) {
  const std::string text =
      ReadTestFile(std::string("data/ansi/") + GetParam().name + ".ansi");
  const auto grid = ParseAnsi(text, kGrid);
  ASSERT_TRUE(grid) << grid.error().ToString();
  DecodeOptions two_pixels;
  two_pixels.cell_width = 1;
  two_pixels.cell_height = 2;
  const auto image = Decode(*grid, two_pixels);
  ASSERT_TRUE(image) << image.error().ToString();
  for (int y = 0; y < image->height(); ++y) {
    for (int x = 0; x < image->width(); ++x) {
      const Rgb expected = EncodedValues(GetParam().pixels(x, y));
      EXPECT_TRUE(image->at(x, y).equalWithAbsError(expected, 1e-6f))
          << x << ", " << y << ": " << image->at(x, y);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(, ProgramOutputTest,
                         testing::Values(Output{"timg_half", CubePixel},
                                         Output{"timg_half_256", CubePixel},
                                         Output{"chafa_full", CubePixel},
                                         Output{"chafa_240", CubePixel},
                                         Output{"chafa_16", BrightPixel},
                                         Output{"chafa_2", BlackOrWhitePixel}),
                         [](const auto& test) {
                           return std::string(test.param.name);
                         });

TEST(ProgramGraphicsTest, AreRefused) {
  for (const auto& [name, says] :
       {std::pair{"chafa_sixel", "sixel"}, std::pair{"chafa_kitty", "kitty"},
        std::pair{"chafa_iterm", "iTerm2"}}) {
    const auto grid = ParseAnsi(
        ReadTestFile(std::string("data/ansi/") + name + ".ansi"), {80, 24});
    ASSERT_FALSE(grid) << name;
    EXPECT_NE(grid.error().what.find(says), std::string::npos);
  }
}

}  // namespace
}  // namespace rtb
