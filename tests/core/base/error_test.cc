#include "core/base/error.h"

#include <gtest/gtest.h>

#include "core/base/result.h"

namespace rtb {
namespace {

TEST(Error, PutsPlaceWhatAndHintOnOneLine) {
  EXPECT_EQ(
      BadInput("scene.yaml:3:7", "found a, expected b", "write b").ToString(),
      "scene.yaml:3:7: found a, expected b (write b)");
  EXPECT_EQ(Failure("out.png", "disk full").ToString(), "out.png: disk full");
  EXPECT_EQ(Missing("", "no device").ToString(), "no device");
}

TEST(Error, KindsAreExitStatuses) {
  EXPECT_EQ(static_cast<int>(Failure("", "").kind), 1);
  EXPECT_EQ(static_cast<int>(BadInput("", "").kind), 2);
  EXPECT_EQ(static_cast<int>(Missing("", "").kind), 3);
}

TEST(Error, NeverPassesAnEscapeSequenceOn) {
  EXPECT_EQ(BadInput("a\x1b[31m", "b\nc").ToString(), "a\\x1b[31m: b\\x0ac");
}

TEST(Printable, ShowsC0DeleteAndC1) {
  EXPECT_EQ(Printable(std::string("\0\t\x7f", 3)), "\\x00\\x09\\x7f");
  // U+009B, the one-character CSI, is C2 9B in UTF-8.
  EXPECT_EQ(Printable("\xC2\x9B"
                      "5m"),
            "\\x9b5m");
}

TEST(Printable, KeepsOtherText) {
  // U+00A0 (C2 A0) is the first character past C1; U+2580 begins with E2.
  EXPECT_EQ(Printable("a \xC2\xA0\xE2\x96\x80"), "a \xC2\xA0\xE2\x96\x80");
  EXPECT_EQ(Printable(""), "");
}

Result<int> Half(int value) {
  if (value % 2 != 0) return Fail(BadInput("value", "is odd"));
  return value / 2;
}

Result<int> Quarter(int value) {
  RTB_ASSIGN_OR_RETURN(const int half, Half(value));
  RTB_RETURN_IF_ERROR(Half(half));
  return half / 2;
}

TEST(Result, MacrosPassValuesAndErrorsOn) {
  EXPECT_EQ(Quarter(12).value(), 3);
  EXPECT_EQ(Quarter(3).error().what, "is odd");
  EXPECT_EQ(Quarter(6).error().what, "is odd");
}

}  // namespace
}  // namespace rtb
