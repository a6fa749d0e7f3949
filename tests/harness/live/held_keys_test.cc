#include "harness/live/held_keys.h"

#include <gtest/gtest.h>

namespace rtb {
namespace {

const KeyEvent kPress{.key = U'w'};
const KeyEvent kRelease{.key = U'w', .action = KeyAction::kRelease};

TEST(HeldKeys, WithReleasesAKeyIsHeldUntilThen) {
  HeldKeys keys;
  keys.set_releases(true);
  keys.Note(Motion::kForward, kPress, 1);
  EXPECT_EQ(keys.At(100).forward, 1);
  keys.Note(Motion::kForward, kRelease, 101);
  EXPECT_EQ(keys.At(101).forward, 0);
}

TEST(HeldKeys, OppositeKeysCancel) {
  HeldKeys keys;
  keys.set_releases(true);
  keys.Note(Motion::kForward, kPress, 0);
  keys.Note(Motion::kBack, kPress, 0);
  EXPECT_EQ(keys.At(1).forward, 0);
  EXPECT_FALSE(keys.At(1).any());
}

TEST(HeldKeys, WithoutReleasesAPressIsAnImpulse) {
  HeldKeys keys;
  keys.Note(Motion::kForward, kPress, 1);
  EXPECT_EQ(keys.At(1 + HeldKeys::kImpulse * 0.9).forward, 1);
  EXPECT_EQ(keys.At(1 + HeldKeys::kImpulse * 1.1).forward, 0);
}

TEST(HeldKeys, RepeatsHoldUntilTheyEnd) {
  HeldKeys keys;
  keys.Note(Motion::kForward, kPress, 0);
  // A keyboard repeats after 0.5 s, 30 times a second.
  double now = 0.5;
  for (int i = 0; i < 30; ++i, now += 1.0 / 30) {
    keys.Note(Motion::kForward, kPress, now);
    EXPECT_EQ(keys.At(now + 0.03).forward, 1);
  }
  EXPECT_EQ(keys.At(now + HeldKeys::kRepeatGap).forward, 0);
}

TEST(HeldKeys, ShiftHurries) {
  HeldKeys keys;
  KeyEvent shifted = kPress;
  shifted.shift = true;
  keys.Note(Motion::kForward, shifted, 0);
  EXPECT_TRUE(keys.At(0.01).hurry);
  keys.Note(Motion::kForward, kPress, 0.02);
  EXPECT_FALSE(keys.At(0.03).hurry);
  keys.NoteShift(true);
  EXPECT_TRUE(keys.At(0.03).hurry);
  keys.Clear();
  EXPECT_FALSE(keys.At(0.03).hurry);
  EXPECT_FALSE(keys.At(0.03).any());
}

}  // namespace
}  // namespace rtb
