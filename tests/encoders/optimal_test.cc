#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "encoders/decode.h"
#include "encoders/fit/fit.h"
#include "encoders/glyphs/glyph_lists.h"
#include "tests/encoders/testing.h"

namespace rtb {
namespace {

constexpr char kMono[] = "/usr/share/fonts/truetype/dejavu/DejaVuSansMono.ttf";

/// An encoder and the sets and resolution that hold all its choices.
struct Rival {
  std::string spec;
  std::string glyphs;
  int width, height;
};

void PrintTo(const Rival& rival, std::ostream* out) { *out << rival.spec; }

class OptimalAgainst : public testing::TestWithParam<Rival> {};

/// The error of a cell that shows one of the atlas's glyphs.
double ErrorIn(const Atlas& atlas, const Cell& cell, Blend blend,
               std::span<const V3d> samples) {
  const int found = atlas.Find(Canonical(cell).glyph);
  EXPECT_GE(found, 0) << static_cast<unsigned>(cell.glyph);
  const FitMask& mask =
      atlas.candidates()[static_cast<std::size_t>(std::max(found, 0))];
  return ErrorOf(mask, cell, blend, samples);
}

// In 500 cells of random samples, some beyond what can be shown, the bound is
// never exceeded (but for noise), and is lower for most.
TEST_P(OptimalAgainst, NeverLoses) {
  const Rival& rival = GetParam();
  constexpr GridSize kGrid{25, 20};
  const int count = rival.width * rival.height;
  const auto values = RandomValues(kGrid.cells() * count, 11);
  const std::string size =
      std::to_string(rival.width) + "x" + std::to_string(rival.height);
  const CellGrid best = EncodeValues(
      "optimal:glyphs=" + rival.glyphs + ":mask=" + size, kGrid, values);
  const CellGrid other = EncodeValues(rival.spec, kGrid, values);
  const auto glyphs = GlyphsOf(rival.glyphs);
  ASSERT_TRUE(glyphs);
  const auto atlas = MakeAtlas(*glyphs, rival.width, rival.height);
  ASSERT_TRUE(atlas) << atlas.error().ToString();
  double optimal_total = 0;
  double rival_total = 0;
  for (std::size_t i = 0; i < best.cells.size(); ++i) {
    std::vector<V3d> samples(static_cast<std::size_t>(count));
    ToBlend(Blend::kSrgb,
            std::span(values).subspan(i * samples.size(), samples.size()),
            samples);
    const double optimal =
        ErrorIn(*atlas, best.cells[i], Blend::kSrgb, samples);
    const double rivals =
        ErrorIn(*atlas, other.cells[i], Blend::kSrgb, samples);
    ASSERT_LE(optimal, rivals + kNoise * (std::sqrt(rivals) + 1)) << i;
    optimal_total += optimal;
    rival_total += rivals;
  }
  EXPECT_LE(optimal_total, rival_total);
}

const Rival kRivals[] = {
    {"half", "blocks", 1, 2},
    {"quadrant", "blocks+quadrants", 2, 2},
    {"quadrant:split=range", "blocks+quadrants", 2, 2},
    {"quadrant:split=best", "blocks+quadrants", 2, 2},
    {"sextant", "blocks+sextants", 2, 3},
    {"octant", "blocks+quadrants+octants", 2, 4},
    {"tiv", "blocks+quadrants+eighths+box", 4, 8},
};

INSTANTIATE_TEST_SUITE_P(, OptimalAgainst, testing::ValuesIn(kRivals),
                         [](const auto& test) {
                           std::string name = test.param.spec;
                           for (char& c : name) {
                             if (c == ':' || c == '=') c = '_';
                           }
                           return name;
                         });

// With 2 x 4 masks and a glyph for each pattern, `octant` is optimal already:
// both find the same error, if not the same side of a pattern.
TEST(OptimalTest, IsWhatOctantFindsOnItsOwnGlyphs) {
  const auto values = RandomValues(8 * 200, 3);
  const CellGrid best = EncodeValues(
      "optimal:glyphs=blocks+quadrants+octants:mask=2x4", {20, 10}, values);
  const CellGrid octants = EncodeValues("octant", {20, 10}, values);
  const auto atlas = MakeAtlas(*GlyphsOf("blocks+quadrants+octants"), 2, 4);
  for (std::size_t i = 0; i < best.cells.size(); ++i) {
    std::vector<V3d> samples(8);
    ToBlend(Blend::kSrgb, std::span(values).subspan(8 * i, 8), samples);
    EXPECT_NEAR(ErrorIn(*atlas, best.cells[i], Blend::kSrgb, samples),
                ErrorIn(*atlas, octants.cells[i], Blend::kSrgb, samples), 1e-6);
  }
}

// A picture of 8 x 16 pixels a cell, decoded, differs from its samples by what
// the fit says: the encoder's masks are those that scores are computed with.
TEST(OptimalTest, DecodesToTheErrorThatItFound) {
  constexpr GridSize kGrid{6, 4};
  constexpr int kCount = 128;
  const auto values = RandomValues(kGrid.cells() * kCount, 21);
  for (const std::string glyphs :
       {"blocks+quadrants+eighths", "wedges+sextants+octants", "ascii+box"}) {
    const CellGrid grid =
        EncodeValues("optimal:glyphs=" + glyphs, kGrid, values);
    const auto image = Decode(grid, {});
    ASSERT_TRUE(image) << image.error().ToString();
    const auto atlas = MakeAtlas(*GlyphsOf(glyphs), 8, 16);
    double squares = 0;
    double fitted = 0;
    for (int cell = 0; cell < kGrid.cells(); ++cell) {
      std::vector<V3d> samples(kCount);
      const auto first = static_cast<std::size_t>(cell * kCount);
      ToBlend(Blend::kSrgb, std::span(values).subspan(first, kCount), samples);
      const int left = cell % kGrid.columns * 8;
      const int top = cell / kGrid.columns * 16;
      for (int i = 0; i < kCount; ++i) {
        const V3d shown(image->at(left + i % 8, top + i / 8));
        squares += (shown - samples[static_cast<std::size_t>(i)]).length2();
      }
      fitted += FitCell(*atlas, Blend::kSrgb, samples).error;
    }
    EXPECT_NEAR(squares / fitted, 1, 1e-6) << glyphs;
  }
}

// NaN and what lies below 0 is black, infinity is white.
TEST(OptimalTest, ShowsWhatIsNoColor) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const auto encode = [](float value) {
    return EncodeValues("optimal", {1, 1}, std::vector<Rgb>(128, Rgb(value)))
        .cells[0];
  };
  const Cell black{U' ', {}, {0, 0, 0}};
  EXPECT_EQ(encode(std::nanf("")), black);
  EXPECT_EQ(encode(-kInfinity), black);
  EXPECT_EQ(encode(-2), black);
  EXPECT_EQ(encode(kInfinity), (Cell{U' ', {}, {255, 255, 255}}));
}

// An A drawn by a font is read back as one, in its colors.
TEST(OptimalTest, ReadsTextThroughAFont) {
  DecodeOptions options;
  options.masks = MaskSource::kFont;
  CellGrid text({3, 1});
  text.cells = {{U'A', {255, 255, 0}, {0, 0, 90}},
                {U'g', {10, 200, 10}, {90, 0, 0}},
                {U'%', {0, 0, 0}, {240, 240, 240}}};
  const auto image = Decode(text, options);
  ASSERT_TRUE(image) << image.error().ToString();
  std::vector<Rgb> values;
  for (int cell = 0; cell < 3; ++cell) {
    for (int i = 0; i < 128; ++i) {
      const Rgb encoded = image->at(8 * cell + i % 8, i / 8);
      values.emplace_back(SrgbDecode(encoded.x), SrgbDecode(encoded.y),
                          SrgbDecode(encoded.z));
    }
  }
  for (const std::string font : {"geometric", kMono}) {
    const CellGrid read = EncodeValues(
        "optimal:glyphs=ascii:atlas='" + font + "'", {3, 1}, values);
    EXPECT_EQ(read.cells, text.cells) << font;
  }
}

void ExpectBadInput(const std::string& spec, const std::string& place) {
  const auto encoder = MakeEncoder(spec);
  ASSERT_FALSE(encoder) << spec;
  EXPECT_EQ(encoder.error().kind, ErrorKind::kBadInput) << spec;
  EXPECT_THAT(encoder.error().place, testing::EndsWith(place)) << spec;
}

TEST(OptimalTest, RefusesWhatItCannotUse) {
  ExpectBadInput("optimal:glyphs=letters", "glyphs");
  for (const std::string mask :
       {"8", "0x16", "8x", "x16", "8x16x", "65x8", "-8x16", "8 x16"}) {
    ExpectBadInput("optimal:mask='" + mask + "'", "mask");
  }
  ExpectBadInput("optimal:blend=hsv", "blend");
  ExpectBadInput("optimal:atlas=none.ttf", "none.ttf");
}

}  // namespace
}  // namespace rtb
