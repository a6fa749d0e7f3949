// Color depths, dithering and fonts, for every encoder.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "encoders/decode.h"
#include "encoders/emit/emit.h"
#include "encoders/glyphs/patterns.h"
#include "encoders/modifiers/dither.h"
#include "encoders/modifiers/repaint.h"
#include "encoders/palette.h"
#include "encoders/parse/parse.h"
#include "tests/encoders/picture_source.h"
#include "tests/encoders/testing.h"

namespace rtb {
namespace {

float Waves(double x, double y, int channel) {
  return static_cast<float>(
      0.4 + 0.5 * std::sin((1.1 + channel) * x + 1.7 * y + 0.1 * x * y));
}

CellGrid EncodeAt(ColorDepth depth, const std::string& spec,
                  const Picture& picture, GridSize size = {16, 8},
                  int threads = 0) {
  PictureSource source(picture);
  EncodeContext context;
  context.depth = depth;
  context.threads = threads;
  auto encoding = Make(spec)->Run(source, size, 0.5, context);
  EXPECT_TRUE(encoding) << encoding.error().ToString();
  return std::move(encoding->grid);
}

constexpr ColorDepth kLimited[] = {ColorDepth::k256, ColorDepth::k16,
                                   ColorDepth::kMono};

std::vector<std::string> Specs() {
  return {"half", "quadrant", "search", "tiv", "sextant", "octant", "braille"};
}

class EveryEncoderAtDepth : public testing::TestWithParam<std::string> {};

TEST_P(EveryEncoderAtDepth, UsesThePaletteAlone) {
  for (const ColorDepth depth : kLimited) {
    for (const char* dither : {"none", "bayer", "noise", "fs"}) {
      const CellGrid grid =
          EncodeAt(depth, GetParam() + ":dither=" + dither, Waves);
      EXPECT_TRUE(FitsDepth(grid, depth)) << dither;
      const auto parsed = ParseAnsi(EmitAnsi(grid, depth), grid.size);
      ASSERT_TRUE(parsed);
      EXPECT_EQ(Canonical(*parsed), Canonical(grid)) << dither;
    }
  }
}

TEST_P(EveryEncoderAtDepth, DoesNotDependOnTheNumberOfThreads) {
  for (const char* dither : {"none", "bayer", "noise", "fs"}) {
    const std::string spec = GetParam() + ":dither=" + dither;
    EXPECT_EQ(EncodeAt(ColorDepth::k16, spec, Waves, {16, 8}, 1),
              EncodeAt(ColorDepth::k16, spec, Waves, {16, 8}, 3));
  }
}

TEST_P(EveryEncoderAtDepth, TakesTheMasksOfAFont) {
  const std::string spec =
      GetParam() + ":atlas=/usr/share/fonts/truetype/dejavu/DejaVuSansMono.ttf";
  const CellGrid grid = EncodeAt(ColorDepth::kTruecolor, spec, Waves);
  EXPECT_EQ(grid.cells.size(), 128u);
}

/// Mean of what a grid shows, channels together.
double MeanOf(const CellGrid& grid) {
  const auto image = Decode(grid, {});
  EXPECT_TRUE(image);
  double sum = 0;
  for (const Rgb& pixel : image->pixels()) sum += pixel.x + pixel.y + pixel.z;
  return sum / (3.0 * static_cast<double>(image->pixels().size()));
}

// A gray between two of the palette: without dithering every cell shows the
// nearer one, with it the mean of the picture comes out.
TEST_P(EveryEncoderAtDepth, DitheringKeepsTheMean) {
  // Dots leave most of a cell dark, whatever their color.
  if (GetParam() == "braille") return;
  struct {
    ColorDepth depth;
    int code;
  } constexpr kCases[] = {{ColorDepth::k16, 100}, {ColorDepth::kMono, 70}};
  for (const auto& [depth, code] : kCases) {
    const float gray = SrgbDecode8(static_cast<std::uint8_t>(code));
    const Picture flat = [gray](double, double, int) { return gray; };
    const GridSize size{32, 32};
    const double wanted = code / 255.0;
    const double plain =
        std::abs(MeanOf(EncodeAt(depth, GetParam(), flat, size)) - wanted);
    for (const char* dither : {"bayer", "noise", "fs"}) {
      const CellGrid grid =
          EncodeAt(depth, GetParam() + ":dither=" + dither, flat, size);
      EXPECT_LT(std::abs(MeanOf(grid) - wanted), 0.35 * plain)
          << dither << " " << code;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(, EveryEncoderAtDepth, testing::ValuesIn(Specs()),
                         [](const auto& test) { return test.param; });

// Glyph and pair together: no other glyph of the set with any two colors of
// the palette is nearer. 2 x 2 samples, quadrants, the 16 ANSI colors.
TEST(Palette, GlyphAndPairAreChosenTogether) {
  PictureSource source(Waves);
  EncodeContext context;
  context.depth = ColorDepth::k16;
  const auto encoding = Make("quadrant")->Run(source, {7, 4}, 0.5, context);
  ASSERT_TRUE(encoding);
  const auto palette = PaletteColors(ColorDepth::k16);
  const Fragments& seen = encoding->evidence.rounds[0].fragments;
  for (int i = 0; i < 28; ++i) {
    std::vector<V3d> samples(4, V3d(0));
    ToBlend(Blend::kSrgb, seen.cell(i), samples);
    const auto error = [&](unsigned pattern, Rgb8 fg, Rgb8 bg) {
      double sum = 0;
      for (unsigned s = 0; s < 4; ++s) {
        const Rgb shown = EncodedValues((pattern >> s & 1) != 0 ? fg : bg);
        sum += (V3d(shown) - samples[s]).length2();
      }
      return sum;
    };
    double least = 1e9;
    for (unsigned pattern = 0; pattern < 16; ++pattern) {
      for (const Rgb8 fg : palette) {
        for (const Rgb8 bg : palette) {
          least = std::min(least, error(pattern, fg, bg));
        }
      }
    }
    const Cell& cell = encoding->grid.cells[static_cast<std::size_t>(i)];
    unsigned pattern = 0;
    while (QuadrantGlyph(pattern) != cell.glyph) ++pattern;
    EXPECT_NEAR(error(pattern, cell.fg, cell.bg), least, 1e-6) << i;
  }
}

// Every rank once in each 8 x 8 block, and any 2 x 2 block spread over four
// quarters of the range: what makes the matrix Bayer's.
TEST(DitherOffset, BayerIsAnOrderedMatrix) {
  std::vector<double> offsets;
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 8; ++x) {
      offsets.push_back(DitherOffset(Dither::kBayer, x, y, 0));
    }
  }
  std::ranges::sort(offsets);
  for (int i = 0; i < 64; ++i) {
    EXPECT_DOUBLE_EQ(offsets[static_cast<std::size_t>(i)],
                     (2 * i + 1) / 64.0 - 1);
  }
  // The classic corner: 0 2 / 3 1 of 4.
  const auto quarter = [](int x, int y) {
    return std::floor(2 * DitherOffset(Dither::kBayer, x, y, 0) + 2);
  };
  EXPECT_EQ(quarter(0, 0), 0);
  EXPECT_EQ(quarter(1, 0), 2);
  EXPECT_EQ(quarter(0, 1), 3);
  EXPECT_EQ(quarter(1, 1), 1);
}

}  // namespace
}  // namespace rtb
