#include "encoders/emit/emit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/encoders/testing.h"

namespace rtb {
namespace {

constexpr Rgb8 kRed{255, 0, 0};
constexpr Rgb8 kBlue{0, 0, 255};

TEST(Utf8Test, UsesOneToFourBytes) {
  EXPECT_EQ(Utf8(U'A'), "A");
  EXPECT_EQ(Utf8(0xA0), "\xC2\xA0");
  EXPECT_EQ(Utf8(0x2584), "\xE2\x96\x84");
  EXPECT_EQ(Utf8(0x1FB00), "\xF0\x9F\xAC\x80");
  EXPECT_EQ(Utf8(0x10FFFF), "\xF4\x8F\xBF\xBF");
}

TEST(EmitJsonTest, ListsCellsRowByRow) {
  CellGrid grid({1, 2});
  grid.cells = {{U'▄', {1, 2, 255}, kBlue}, {U'"', kRed, {}}};
  EXPECT_EQ(EmitJson(grid),
            "{\"columns\":1,\"rows\":2,\"cells\":["
            "[\"▄\",\"#0102ff\",\"#0000ff\"],"
            "[\"\\\"\",\"#ff0000\",\"#000000\"]]}\n");
}

// Two equal half blocks are one rectangle, and so is the background of all
// three cells; the letter stands on the baseline of glyphs/font.h: 0.266 +
// 12.334 from the top.
TEST(EmitSvgTest, MergesRectanglesAndPlacesText) {
  const std::string svg = EmitSvg(
      Row({{U'▄', kRed, kBlue}, {U'▄', kRed, kBlue}, {U'<', kRed, kBlue}}), 8,
      16);
  EXPECT_EQ(
      svg,
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"24\" height=\"16\" "
      "viewBox=\"0 0 24 16\" shape-rendering=\"crispEdges\" "
      "font-family=\"'DejaVu Sans Mono', 'DejaVu Sans', monospace\" "
      "font-size=\"13.287916\">\n"
      "<rect x=\"0\" y=\"0\" width=\"24\" height=\"16\" fill=\"#0000ff\"/>\n"
      "<rect x=\"0\" y=\"8\" width=\"16\" height=\"8\" fill=\"#ff0000\"/>\n"
      "<text x=\"16\" y=\"12.600162\" textLength=\"8\" "
      "lengthAdjust=\"spacingAndGlyphs\" fill=\"#ff0000\">&lt;</text>\n"
      "</svg>\n");
}

TEST(EmitSvgTest, DrawsShadesTranslucentAndFullBlocksWithoutBackground) {
  const std::string svg =
      EmitSvg(Row({{U'░', kRed, kBlue}, {U'█', kRed, kBlue}}), 8, 16);
  EXPECT_THAT(
      svg, testing::HasSubstr("<rect x=\"0\" y=\"0\" width=\"8\" height=\"16\" "
                              "fill=\"#0000ff\"/>\n"
                              "<rect x=\"0\" y=\"0\" width=\"8\" height=\"16\" "
                              "fill=\"#ff0000\" fill-opacity=\"0.25\"/>\n"
                              "<rect x=\"8\" y=\"0\" width=\"8\" height=\"16\" "
                              "fill=\"#ff0000\"/>\n</svg>"));
}

// U+1FB3C in the second cell: (0, 2/3), (1/2, 1) and the lower left corner.
TEST(EmitSvgTest, DrawsWedgesAsPolygons) {
  const std::string svg = EmitSvg(
      Row({{U' ', kRed, kBlue}, {char32_t{0x1FB3C}, kRed, kBlue}}), 12, 24);
  EXPECT_THAT(svg, testing::HasSubstr(
                       "<rect x=\"0\" y=\"0\" width=\"24\" height=\"24\" "
                       "fill=\"#0000ff\"/>\n"
                       "<polygon points=\"18,24 12,24 12,16\" fill=\"#ff0000\" "
                       "shape-rendering=\"geometricPrecision\"/>\n</svg>"));
}

// Thirds of 16 rows.
TEST(EmitSvgTest, KeepsFractions) {
  EXPECT_THAT(EmitSvg(Row({{char32_t{0x1FB00}, kRed, kBlue}}), 8, 16),
              testing::HasSubstr("<rect x=\"0\" y=\"0\" width=\"4\" "
                                 "height=\"5.3333333\" fill=\"#ff0000\"/>"));
}

}  // namespace
}  // namespace rtb
