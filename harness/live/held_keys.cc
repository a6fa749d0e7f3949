#include "harness/live/held_keys.h"

#include <limits>

namespace rtb {

void HeldKeys::Note(Motion motion, const KeyEvent& event, double now) {
  Key& key = keys_[static_cast<std::size_t>(motion)];
  if (event.action == KeyAction::kRelease) {
    key.until = now;
    return;
  }
  key_shift_ = event.shift;
  if (releases_) {
    key.until = std::numeric_limits<double>::infinity();
  } else {
    const bool repeat = now - key.pressed < kRepeatDelay;
    key.until = now + (repeat ? kRepeatGap : kImpulse);
  }
  key.pressed = now;
}

void HeldKeys::Clear() {
  keys_ = {};
  shift_ = false;
  key_shift_ = false;
}

MotionInput HeldKeys::At(double now) const {
  MotionInput input;
  input.forward = Value(Motion::kForward, now) - Value(Motion::kBack, now);
  input.right = Value(Motion::kRight, now) - Value(Motion::kLeft, now);
  input.up = Value(Motion::kUp, now) - Value(Motion::kDown, now);
  input.turn_right =
      Value(Motion::kTurnRight, now) - Value(Motion::kTurnLeft, now);
  input.turn_up = Value(Motion::kTurnUp, now) - Value(Motion::kTurnDown, now);
  input.hurry = shift_ || key_shift_;
  return input;
}

double HeldKeys::Value(Motion motion, double now) const {
  return now < keys_[static_cast<std::size_t>(motion)].until ? 1 : 0;
}

}  // namespace rtb
