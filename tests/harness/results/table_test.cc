#include "harness/results/table.h"

#include <gtest/gtest.h>

#include "harness/results/display_width.h"

namespace rtb {
namespace {

TEST(DisplayWidthTest, CountsTerminalColumns) {
  EXPECT_EQ(DisplayWidth(""), 0);
  EXPECT_EQ(DisplayWidth("abc"), 3);
  EXPECT_EQ(DisplayWidth("\u00e9\u2580\U0001FB00"), 3);  // e acute, blocks
  EXPECT_EQ(DisplayWidth("e\u0301"), 1);                 // e, combining acute
  EXPECT_EQ(DisplayWidth("\u6f22\u5b57"), 4);            // Han characters
  EXPECT_EQ(DisplayWidth("\U0001F600"), 2);              // emoji
  EXPECT_EQ(DisplayWidth("\xff\xe2\x96"), 3);            // no UTF-8
}

TEST(TableTest, AlignsColumns) {
  const Table table = {{{"name", false}, {"value"}, {"\u0394E"}},
                       {{"a", "1.5", "-"}, {"\u6f22\u5b57 b", "-20", "100"}}};
  EXPECT_EQ(FormatTable(table),
            "name    value   \u0394E\n"
            "------  -----  ---\n"
            "a         1.5    -\n"
            "\u6f22\u5b57 b    -20  100\n");
}

TEST(TableTest, HasNoBlanksAtLineEnds) {
  const Table table = {{{"wide heading", false}}, {{"x"}}};
  EXPECT_EQ(FormatTable(table),
            "wide heading\n"
            "------------\n"
            "x\n");
}

TEST(TableTest, ShowsControlCharacters) {
  const Table table = {{{"a", false}}, {{"\x1b[2J"}}};
  EXPECT_EQ(FormatTable(table),
            "a\n"
            "-------\n"
            "\\x1b[2J\n");
}

TEST(FormatFixedTest, RoundsToDigits) {
  EXPECT_EQ(FormatFixed(1234.5678, 2), "1234.57");
  EXPECT_EQ(FormatFixed(-0.5, 3), "-0.500");
  EXPECT_EQ(FormatFixed(3, 0), "3");
}

}  // namespace
}  // namespace rtb
