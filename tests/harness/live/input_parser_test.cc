#include "harness/live/input_parser.h"

#include <gtest/gtest.h>

#include <random>

namespace rtb {
namespace {

std::vector<InputEvent> Parse(std::string_view bytes) {
  InputParser parser;
  return parser.Feed(bytes);
}

InputEvent Key(char32_t key, KeyAction action = KeyAction::kPress,
               bool shift = false, bool alt = false, bool ctrl = false) {
  return KeyEvent{key, action, shift, alt, ctrl};
}

using Events = std::vector<InputEvent>;

TEST(InputParser, PlainCharacters) {
  EXPECT_EQ(Parse("w"), Events{Key(U'w')});
  EXPECT_EQ(Parse("W"), Events{Key(U'w', KeyAction::kPress, true)});
  EXPECT_EQ(Parse("?"), Events{Key(U'?')});
  EXPECT_EQ(Parse("\xC3\xA9"), Events{Key(U'é')});
}

TEST(InputParser, ControlBytes) {
  EXPECT_EQ(Parse("\x03"),
            (Events{Key(U'c', KeyAction::kPress, false, false, true)}));
  EXPECT_EQ(Parse("\r"), Events{Key(kKeyEnter)});
  EXPECT_EQ(Parse("\t"), Events{Key(kKeyTab)});
  EXPECT_EQ(Parse("\x7f"), Events{Key(kKeyBackspace)});
}

TEST(InputParser, ArrowsInBothForms) {
  EXPECT_EQ(
      Parse("\x1b[A\x1b[B\x1b[C\x1b[D"),
      (Events{Key(kKeyUp), Key(kKeyDown), Key(kKeyRight), Key(kKeyLeft)}));
  EXPECT_EQ(Parse("\x1bOA"), Events{Key(kKeyUp)});
  EXPECT_EQ(Parse("\x1b[1;2A"), (Events{Key(kKeyUp, KeyAction::kPress, true)}));
  EXPECT_EQ(Parse("\x1b[5~\x1b[6~"),
            (Events{Key(kKeyPageUp), Key(kKeyPageDown)}));
}

TEST(InputParser, KittyKeysAndTheirReleases) {
  EXPECT_EQ(Parse("\x1b[119u"), Events{Key(U'w')});
  EXPECT_EQ(Parse("\x1b[119;1:1u"), Events{Key(U'w')});
  EXPECT_EQ(Parse("\x1b[119;1:2u"), Events{Key(U'w', KeyAction::kRepeat)});
  EXPECT_EQ(Parse("\x1b[119;1:3u"), Events{Key(U'w', KeyAction::kRelease)});
  // Num Lock is 128 of the modifiers: 129 - 1.
  EXPECT_EQ(Parse("\x1b[119;129:3u"), Events{Key(U'w', KeyAction::kRelease)});
  EXPECT_EQ(Parse("\x1b[1;1:3A"), Events{Key(kKeyUp, KeyAction::kRelease)});
  EXPECT_EQ(Parse("\x1b[99;5u"),
            (Events{Key(U'c', KeyAction::kPress, false, false, true)}));
  EXPECT_EQ(Parse("\x1b[27u"), Events{Key(kKeyEscape)});
}

TEST(InputParser, KittyTellsTheShiftedCharacter) {
  // '/' with shift is '?' on an American keyboard.
  EXPECT_EQ(Parse("\x1b[47:63;2u"),
            (Events{Key(U'?', KeyAction::kPress, true)}));
  EXPECT_EQ(Parse("\x1b[119:87;2u"),
            (Events{Key(U'w', KeyAction::kPress, true)}));
  EXPECT_EQ(Parse("\x1b[57441;2u"),
            (Events{Key(kKeyShift, KeyAction::kPress, true)}));
  EXPECT_EQ(Parse("\x1b[57358u"), Events{});  // Caps Lock.
}

TEST(InputParser, Mouse) {
  EXPECT_EQ(Parse("\x1b[<0;10;5M"),
            (Events{MouseEvent{MouseAction::kPress, 0, 9, 4}}));
  EXPECT_EQ(Parse("\x1b[<32;11;5M"),
            (Events{MouseEvent{MouseAction::kDrag, 0, 10, 4}}));
  EXPECT_EQ(Parse("\x1b[<0;11;5m"),
            (Events{MouseEvent{MouseAction::kRelease, 0, 10, 4}}));
  EXPECT_EQ(Parse("\x1b[<64;1;1M\x1b[<65;1;1M"),
            (Events{MouseEvent{MouseAction::kWheelUp, 0, 0, 0},
                    MouseEvent{MouseAction::kWheelDown, 0, 0, 0}}));
}

TEST(InputParser, AnswersToTheProbe) {
  EXPECT_EQ(Parse("\x1b[?2026;2$y\x1b[?0u\x1bP1$r48:2::1:2:3m\x1b\\"
                  "\x1bP>|foot(1.13.1)\x1b\\\x1b[6;18;9t\x1b[?62;4c\x1b[0n"),
            (Events{ReplyEvent{ReplyEvent::Kind::kSyncMode, 2, ""},
                    ReplyEvent{ReplyEvent::Kind::kKeyboard, 0, ""},
                    ReplyEvent{ReplyEvent::Kind::kColors, 0, "48:2::1:2:3m"},
                    ReplyEvent{ReplyEvent::Kind::kVersion, 0, "foot(1.13.1)"},
                    ReplyEvent{ReplyEvent::Kind::kCellSize, 9, "18"},
                    ReplyEvent{ReplyEvent::Kind::kAttributes, 0, ""},
                    ReplyEvent{ReplyEvent::Kind::kStatus, 0, ""}}));
}

TEST(InputParser, EscapeAloneWaitsForSilence) {
  InputParser parser;
  EXPECT_EQ(parser.Feed("\x1b"), Events{});
  EXPECT_TRUE(parser.pending());
  EXPECT_EQ(parser.Flush(), Events{Key(kKeyEscape)});
  EXPECT_FALSE(parser.pending());
  EXPECT_EQ(parser.Feed("\x1b\x1b[A"), (Events{Key(kKeyEscape), Key(kKeyUp)}));
  EXPECT_EQ(parser.Feed("\x1bx"),
            (Events{Key(U'x', KeyAction::kPress, false, true)}));
}

TEST(InputParser, ReadsMayEndAnywhere) {
  const std::string bytes =
      "w\x1b[A\xC3\xA9\x1b[119;129:3u\x1b[<32;100;50M\x1bOB"
      "\x1bP>|foot(1.13.1)\x1b\\\x1b[?62c?";
  const Events whole = Parse(bytes);
  EXPECT_EQ(whole.size(), 9u);
  for (std::size_t split = 1; split < bytes.size(); ++split) {
    InputParser parser;
    Events events = parser.Feed(bytes.substr(0, split));
    const Events rest = parser.Feed(bytes.substr(split));
    events.insert(events.end(), rest.begin(), rest.end());
    EXPECT_EQ(events, whole) << "split at " << split;
  }
}

TEST(InputParser, SurvivesGarbageAndGoesOn) {
  std::mt19937 random(7);
  std::uniform_int_distribution<int> byte(0, 255);
  for (int round = 0; round < 200; ++round) {
    InputParser parser;
    std::string garbage(64, '\0');
    for (char& c : garbage) c = static_cast<char>(byte(random));
    parser.Feed(garbage);
    parser.Flush();
    EXPECT_EQ(parser.Feed("w"), Events{Key(U'w')});
  }
}

TEST(InputParser, ASequenceWithoutEndIsGivenUp) {
  InputParser parser;
  parser.Feed("\x1bP" + std::string(10000, 'x'));
  parser.Flush();
  EXPECT_EQ(parser.Feed("w"), Events{Key(U'w')});
}

}  // namespace
}  // namespace rtb
