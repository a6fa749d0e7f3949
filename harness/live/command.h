/// @file
/// What keys do: the table that input looks up and that `?` prints.
#pragma once

#include <optional>
#include <span>

#include "harness/live/input_event.h"

namespace rtb {

/// What one press of a key does.
enum class LiveCommand {
  kHelp,
  kPanel,
  kNextEncoder,
  kPreviousEncoder,
  kSplit,
  kDividerLeft,
  kDividerRight,
  kSwapSides,
  kScenePicker,
  kIntegrator,
  kMoreSamples,
  kFewerSamples,
  kBackend,
  kBrighter,
  kDarker,
  kColorDepth,
  kPause,
  kStep,
  kOrbit,
  kTemporal,
  kGovernor,
  kScreenshot,
  kRecord,
  kQuality,
  kReset,
  kRedraw,
  kClose,
  kSuspend,
  kQuit,
};

/// What a key does while it is held.
enum class Motion {
  kForward,
  kBack,
  kLeft,
  kRight,
  kUp,
  kDown,
  kTurnLeft,
  kTurnRight,
  kTurnUp,
  kTurnDown,
  kCount,
};

/// One row of the table.
struct KeyBinding {
  char32_t key;
  bool shift;  ///< Of letters; whatever it takes to type other characters.
  bool ctrl;
  LiveCommand command;
  const char* label;  ///< How help names the key; nullptr: not shown.
  const char* text;   ///< What it does.
};

/// One key that moves while it is held; shift hurries.
struct MotionBinding {
  char32_t key;
  Motion motion;
};

/// All rows, in the order of help.
std::span<const KeyBinding> KeyBindings();

/// The command of a key press; none for other keys.
std::optional<LiveCommand> FindCommand(const KeyEvent& event);

/// The motion of a key; none for other keys.
std::optional<Motion> FindMotion(const KeyEvent& event);

/// What help says of motions and the mouse: label and text.
struct HelpLine {
  const char* label;
  const char* text;
};
std::span<const HelpLine> MotionHelp();

}  // namespace rtb
