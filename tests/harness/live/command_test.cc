#include "harness/live/command.h"

#include <gtest/gtest.h>

#include <set>
#include <tuple>

namespace rtb {
namespace {

KeyEvent Press(char32_t key, bool shift = false, bool ctrl = false) {
  return {.key = key, .shift = shift, .ctrl = ctrl};
}

TEST(Command, EveryCommandHasAKeyAndHelpNamesIt) {
  std::set<LiveCommand> bound, explained;
  for (const KeyBinding& row : KeyBindings()) {
    bound.insert(row.command);
    if (row.label != nullptr) explained.insert(row.command);
  }
  // kQuit is the last of the enumeration.
  const auto all = static_cast<std::size_t>(LiveCommand::kQuit) + 1;
  EXPECT_EQ(bound.size(), all);
  // Opposites share a line: previous encoder, divider right, fewer rays,
  // darker.
  EXPECT_EQ(explained.size(), all - 4);
}

TEST(Command, NoKeyMeansTwoThings) {
  std::set<std::tuple<char32_t, bool, bool>> seen;
  for (const KeyBinding& row : KeyBindings()) {
    EXPECT_TRUE(seen.insert({row.key, row.shift, row.ctrl}).second);
    if (!row.ctrl) {
      EXPECT_FALSE(FindMotion(Press(row.key))) << static_cast<int>(row.key);
    }
  }
}

TEST(Command, ShiftCountsForLettersAlone) {
  EXPECT_EQ(FindCommand(Press(U'n')), LiveCommand::kNextEncoder);
  EXPECT_EQ(FindCommand(Press(U'n', true)), LiveCommand::kPreviousEncoder);
  EXPECT_EQ(FindCommand(Press(U'?')), LiveCommand::kHelp);
  EXPECT_EQ(FindCommand(Press(U'?', true)), LiveCommand::kHelp);
  EXPECT_EQ(FindCommand(Press(U'c', false, true)), LiveCommand::kQuit);
  EXPECT_EQ(FindCommand(Press(U'y')), std::nullopt);
}

TEST(Command, ShiftDoesNotKeepFromMoving) {
  EXPECT_EQ(FindMotion(Press(U'w')), Motion::kForward);
  EXPECT_EQ(FindMotion(Press(U'w', true)), Motion::kForward);
  EXPECT_EQ(FindMotion(Press(U'c', false, true)), std::nullopt);
}

}  // namespace
}  // namespace rtb
