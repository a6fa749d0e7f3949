#include "encoders/parse/terminal_input.h"

#include <gtest/gtest.h>

namespace rtb {
namespace {

std::string Input(std::string_view output) {
  const auto input = TerminalInput(output);
  return input ? *input : input.error().ToString();
}

TEST(TerminalInputTest, AddsCarriageReturns) {
  EXPECT_EQ(Input("a\nb"), "a\r\nb");
  EXPECT_EQ(Input("a\n\x1b[2J"), "a\r\n\x1b[2J");
}

TEST(TerminalInputTest, EndsWithWhatDrawsLast) {
  EXPECT_EQ(Input("a\nb\n\n"), "a\r\nb");
  EXPECT_EQ(Input("a\x1b[0m\n\x1b(B\x1b[m\x1b]0;t\a\x1b[?1049l\x1b[9;1H\n"),
            "a");
  EXPECT_EQ(Input("a\n\x1b["), "a");
  EXPECT_EQ(Input("\n\n"), "");
  EXPECT_EQ(Input(""), "");
}

TEST(TerminalInputTest, KeepsTheReversalOfTheScreen) {
  EXPECT_EQ(Input("a\n\x1b[?5h\n"), "a\x1b[?5h");
}

TEST(TerminalInputTest, BoundsParameters) {
  EXPECT_EQ(Input("\x1b[123456;7Ha"), "\x1b[9999;7Ha");
  EXPECT_EQ(Input("\x1b[1;2;3;4;5;6;7;8;9;10;11;12;13;14;15;16;17;18Ha"),
            "\x1b[1;2;3;4;5;6;7;8;9;10;11;12;13;14;15;Ha");
}

TEST(TerminalInputTest, LeavesOutBrokenSequences) {
  EXPECT_EQ(Input("\x1b[3\x1b[2Ca\x1b"), "\x1b[2Ca");
  EXPECT_EQ(Input("\x1b]0;never ended a"), "");
}

// Private sequences that end in m or b are no colors and no repetition.
TEST(TerminalInputTest, PassesPrivateSequencesOn) {
  EXPECT_EQ(Input("\x1b[>4;1ma"), "\x1b[>4;1ma");
  EXPECT_EQ(Input("a\x1b[?2bc"), "a\x1b[?2bc");
}

}  // namespace
}  // namespace rtb
