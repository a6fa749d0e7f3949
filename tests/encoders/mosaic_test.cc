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

struct Kind {
  const char* name;
  int samples;
  char32_t (*glyph)(unsigned);
};

void PrintTo(const Kind& kind, std::ostream* out) { *out << kind.name; }

class MosaicTest : public testing::TestWithParam<Kind> {};

// White where a bit of the pattern is set, black elsewhere.
TEST_P(MosaicTest, DrawsEveryPattern) {
  const int patterns = 1 << GetParam().samples;
  std::vector<std::vector<int>> codes;
  for (int pattern = 0; pattern < patterns; ++pattern) {
    std::vector<int>& cell = codes.emplace_back();
    for (int i = 0; i < GetParam().samples; ++i) {
      cell.push_back((pattern >> i & 1) * 255);
    }
  }
  const CellGrid grid =
      EncodeValues(GetParam().name, {patterns, 1}, GrayValues(codes));
  for (int pattern = 1; pattern + 1 < patterns; ++pattern) {
    EXPECT_EQ(grid.at(pattern, 0),
              (Cell{GetParam().glyph(static_cast<unsigned>(pattern)), Gray(255),
                    Gray(0)}));
  }
  // All alike: the empty pattern, on the one color.
  EXPECT_EQ(grid.at(0, 0), (Cell{GetParam().glyph(0), {}, Gray(0)}));
  EXPECT_EQ(grid.at(patterns - 1, 0),
            (Cell{GetParam().glyph(0), {}, Gray(255)}));
}

TEST_P(MosaicTest, TakesTheBestOfAllPartitions) {
  for (const char* blend : {"srgb", "linear", "oklab"}) {
    SCOPED_TRACE(blend);
    ExpectBestPartitions(std::string(GetParam().name) + ":blend=" + blend,
                         GetParam().samples, *ReadBlend({{"blend", blend}}),
                         GetParam().glyph);
  }
}

INSTANTIATE_TEST_SUITE_P(, MosaicTest,
                         testing::Values(Kind{"sextant", 6, SextantGlyph},
                                         Kind{"octant", 8, OctantGlyph},
                                         Kind{"braille", 8, BrailleGlyph}),
                         [](const auto& test) {
                           return std::string(test.param.name);
                         });

// Samples: 0 and 200 in the first row, 100 in the others. {0} | rest and
// {200} | rest are equally good (mirrored around 100). As masks the first is
// 000001; the second is 000010, the lower of it and its complement. The lower
// wins, and its other side is the brighter: (200 + 4 * 100) / 5 = 120.
TEST(SextantTest, LowerPartitionWinsATie) {
  EXPECT_EQ(EncodeOneGray("sextant", {0, 200, 100, 100, 100, 100}),
            (Cell{SextantGlyph(0x3E), Gray(120), Gray(0)}));
  EXPECT_EQ(EncodeOneGray("sextant", {200, 0, 100, 100, 100, 100}),
            (Cell{SextantGlyph(0x01), Gray(200), Gray(80)}));
}

TEST(BrailleTest, UniformCellsHaveNoDots) {
  EXPECT_EQ(EncodeOneGray("braille", std::vector<int>(8, 77)),
            (Cell{0x2800, {}, Gray(77)}));
}

}  // namespace
}  // namespace rtb
