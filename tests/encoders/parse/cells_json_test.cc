#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "encoders/emit/emit.h"
#include "encoders/emit/hex_color.h"
#include "encoders/parse/glyph_text.h"
#include "encoders/parse/parse.h"
#include "tests/encoders/testing.h"

namespace rtb {
namespace {

using testing::HasSubstr;

std::string ErrorOf(const std::string& json) {
  const auto grid = ParseCellsJson(json, "cells.json");
  if (grid) return "no error";
  EXPECT_EQ(grid.error().kind, ErrorKind::kBadInput);
  EXPECT_THAT(grid.error().place, testing::StartsWith("cells.json"));
  return grid.error().ToString();
}

/// A 1 x 1 grid around the text of its cell.
std::string OneCell(const std::string& cell) {
  return R"({"columns": 1, "rows": 1, "cells": [)" + cell + "]}";
}

TEST(ParseCellsJsonTest, ReadsWhatEmitJsonWrites) {
  CellGrid grid({3, 2});
  grid.cells = {{U'▄', {1, 2, 3}, {4, 5, 6}}, {U'"', {}, {}}, {U'\\', {}, {}},
                {char32_t{0x1FB00}, {}, {}},  {U'&', {}, {}}, {U' ', {}, {}}};
  const auto parsed = ParseCellsJson(EmitJson(grid), "test");
  ASSERT_TRUE(parsed) << parsed.error().ToString();
  EXPECT_EQ(*parsed, grid);
}

TEST(ParseCellsJsonTest, NamesThePlaceOfEveryError) {
  EXPECT_THAT(ErrorOf("{"), HasSubstr("not valid JSON"));
  EXPECT_THAT(ErrorOf("[]"), HasSubstr("expected {\"columns\""));
  EXPECT_THAT(ErrorOf(R"({"rows": 1})"), HasSubstr("columns: is missing"));
  EXPECT_THAT(ErrorOf(R"({"columns": 1, "rows": 0})"),
              HasSubstr("rows: expected an integer from 1 to 16384, found 0"));
  EXPECT_THAT(ErrorOf(R"({"columns": 1.5, "rows": 1})"), HasSubstr("columns"));
  EXPECT_THAT(ErrorOf(R"({"columns": 99999999999999999999, "rows": 1})"),
              HasSubstr("columns"));
  EXPECT_THAT(ErrorOf(R"({"columns": 2, "rows": 2, "cells": []})"),
              HasSubstr("= 4 cells, found 0"));
  EXPECT_THAT(ErrorOf(R"({"columns": 2, "rows": 2})"), HasSubstr("cells"));
  EXPECT_THAT(ErrorOf(OneCell("3")), HasSubstr("cells[0]: expected [glyph"));
  EXPECT_THAT(ErrorOf(OneCell(R"(["x", "#000000"])")), HasSubstr("cells[0]"));
  EXPECT_THAT(ErrorOf(OneCell(R"(["x", "#00000", "#000000"])")),
              HasSubstr("expected a color \"#rrggbb\", found \"#00000\""));
  EXPECT_THAT(ErrorOf(OneCell(R"(["xy", "#000000", "#000000"])")),
              HasSubstr("one visible character"));
  EXPECT_THAT(ErrorOf(OneCell("[\"\xFF\", \"#000000\", \"#000000\"]")),
              HasSubstr("not valid JSON"));
}

// A grid from a file must not smuggle escape sequences into a terminal.
TEST(ParseCellsJsonTest, RefusesControlCharacters) {
  for (const char* glyph : {"\\u001b", "\\u009b", "\\u0000", "\\n", ""}) {
    const std::string cell =
        std::string("[\"") + glyph + R"(", "#000000", "#000000"])";
    EXPECT_THAT(ErrorOf(OneCell(cell)), HasSubstr("one visible character"));
  }
}

TEST(GlyphTextTest, TakesOneCodePointOfValidUtf8) {
  EXPECT_EQ(ParseGlyph("A"), U'A');
  EXPECT_EQ(ParseGlyph("\xC2\xA0"), 0xA0u);
  EXPECT_EQ(ParseGlyph("▄"), U'▄');
  EXPECT_EQ(ParseGlyph("\xF0\x9F\xAC\x80"), 0x1FB00u);
  EXPECT_FALSE(ParseGlyph(""));
  EXPECT_FALSE(ParseGlyph("ab"));
  EXPECT_FALSE(ParseGlyph("\xC1\x81"));          // Overlong A.
  EXPECT_FALSE(ParseGlyph("\xED\xA0\x80"));      // A surrogate.
  EXPECT_FALSE(ParseGlyph("\x96"));              // A continuation alone.
  EXPECT_FALSE(ParseGlyph("\xF4\x90\x80\x80"));  // Beyond U+10FFFF.
  EXPECT_FALSE(ParseGlyph("▄a"));
}

TEST(HexColorTest, ReadsSixDigits) {
  EXPECT_EQ(ParseHexColor("#0aFf10"), (Rgb8{10, 255, 16}));
  EXPECT_EQ(HexColor({10, 255, 16}), "#0aff10");
  for (const char* bad : {"", "#", "#00000", "#0000000", "000000#", "#00000g",
                          "#-00001", "#+00001", "# 00001", "#0x0001"}) {
    EXPECT_FALSE(ParseHexColor(bad)) << bad;
  }
}

}  // namespace
}  // namespace rtb
