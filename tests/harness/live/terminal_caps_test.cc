#include "harness/live/terminal_caps.h"

#include <gtest/gtest.h>

#include "harness/live/input_parser.h"
#include "harness/live/terminfo.h"

namespace rtb {
namespace {

TerminalCaps CapsOf(std::string_view answers) {
  TerminalCaps caps;
  InputParser parser;
  for (const InputEvent& event : parser.Feed(answers)) {
    caps.Note(std::get<ReplyEvent>(event));
  }
  return caps;
}

TEST(TerminalCaps, OfATerminalThatHasItAll) {
  const TerminalCaps caps = CapsOf(
      "\x1b[?2026;2$y\x1b[?0u\x1bP1$r0;48:2::1:2:3m\x1b\\"
      "\x1bP>|kitty(0.26.5)\x1b\\\x1b[6;18;9t\x1b[?62c");
  EXPECT_TRUE(caps.answered);
  EXPECT_TRUE(caps.sync);
  EXPECT_TRUE(caps.key_release);
  EXPECT_TRUE(caps.truecolor);
  EXPECT_EQ(caps.version, "kitty(0.26.5)");
  EXPECT_EQ(caps.cell_width, 9);
  EXPECT_EQ(caps.cell_height, 18);
}

TEST(TerminalCaps, OfXterm) {
  // No mode 2026, no kitty keys.
  const TerminalCaps caps =
      CapsOf("\x1b[?2026;0$y\x1bP1$r48:2:1:2:3m\x1b\\\x1b[?64;1c");
  EXPECT_TRUE(caps.answered);
  EXPECT_FALSE(caps.sync);
  EXPECT_FALSE(caps.key_release);
  EXPECT_TRUE(caps.truecolor);
}

TEST(TerminalCaps, ANameCannotCarryEscapeSequences) {
  EXPECT_EQ(CapsOf("\x1bP>|a\x08z\x1b\\").version, "a\\x08z");
}

TEST(ChooseDepth, InTheOrderOfHowSureItIs) {
  TerminalCaps plain, truecolor;
  truecolor.truecolor = true;
  const auto depth = [](const TerminalHints& hints, const TerminalCaps& caps) {
    return ChooseDepth(hints, caps).depth;
  };
  EXPECT_EQ(depth({"xterm", "", true, 256}, truecolor), ColorDepth::kMono);
  EXPECT_EQ(depth({"xterm", "", false, 8}, truecolor), ColorDepth::kTruecolor);
  EXPECT_EQ(depth({"xterm", "truecolor", false, 8}, plain),
            ColorDepth::kTruecolor);
  EXPECT_EQ(depth({"xterm-256color", "", false, 256}, plain), ColorDepth::k256);
  EXPECT_EQ(depth({"linux", "", false, 8}, plain), ColorDepth::k16);
  EXPECT_EQ(depth({"vt100", "", false, -1}, plain), ColorDepth::kMono);
}

TEST(Terminfo, RefusesWhatCannotBeDrawnOn) {
  EXPECT_EQ(ReadTerminfo("").error().kind, ErrorKind::kBadInput);
  EXPECT_EQ(ReadTerminfo("no-such-terminal").error().kind,
            ErrorKind::kBadInput);
  EXPECT_EQ(ReadTerminfo("dumb").error().kind, ErrorKind::kBadInput);
}

TEST(Terminfo, KnowsXterm) {
  const auto info = ReadTerminfo("xterm-256color");
  if (!info) GTEST_SKIP() << "terminfo has no xterm-256color here";
  EXPECT_EQ(info->colors, 256);
  EXPECT_NE(info->enter.find("\x1b[?1049h"), std::string::npos);
  EXPECT_NE(info->leave.find("\x1b[?1049l"), std::string::npos);
}

}  // namespace
}  // namespace rtb
