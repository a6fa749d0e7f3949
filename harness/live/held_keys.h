/// @file
/// HeldKeys: which motions are on, from real key-up events or, where a
/// terminal sends none, from the keyboard's repeats.
#pragma once

#include <array>

#include "harness/live/command.h"

namespace rtb {

/// Directions in [-1, 1] that a person asks for.
struct MotionInput {
  double forward = 0;
  double right = 0;
  double up = 0;
  double turn_right = 0;
  double turn_up = 0;
  bool hurry = false;

  bool any() const {
    return forward != 0 || right != 0 || up != 0 || turn_right != 0 ||
           turn_up != 0;
  }
};

/// Times are seconds on any clock that never goes back.
class HeldKeys {
 public:
  /// Without releases a first press holds for kImpulse, and one that repeats
  /// until kRepeatGap after the last repeat.
  static constexpr double kImpulse = 0.12;
  static constexpr double kRepeatGap = 0.15;
  /// A second press within this time is a repeat: longer than the usual delay
  /// before a keyboard repeats (0.5 s).
  static constexpr double kRepeatDelay = 0.7;

  /// Whether the terminal tells when a key goes up.
  void set_releases(bool releases) { releases_ = releases; }

  /// A key of this motion went down, repeated or went up.
  void Note(Motion motion, const KeyEvent& event, double now);
  /// The shift key itself (kitty's protocol).
  void NoteShift(bool down) { shift_ = down; }
  /// Lets go of everything, as when the terminal was resized or suspended.
  void Clear();

  /// What is held now.
  MotionInput At(double now) const;

 private:
  struct Key {
    double pressed = -1e9;  ///< When the last press came.
    double until = -1e9;    ///< Held before this time.
  };

  double Value(Motion motion, double now) const;

  bool releases_ = false;
  bool shift_ = false;      ///< The key itself is down.
  bool key_shift_ = false;  ///< The last key came with it.
  std::array<Key, static_cast<std::size_t>(Motion::kCount)> keys_;
};

}  // namespace rtb
