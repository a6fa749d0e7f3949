#include "harness/live/command.h"

#include <algorithm>

namespace rtb {
namespace {

// clang-format off
constexpr KeyBinding kBindings[] = {
#include "harness/live/command_table.inc"
};
// clang-format on

constexpr MotionBinding kMotions[] = {
    {U'w', Motion::kForward},      {U's', Motion::kBack},
    {U'a', Motion::kLeft},         {U'd', Motion::kRight},
    {U'e', Motion::kUp},           {U' ', Motion::kUp},
    {U'q', Motion::kDown},         {U'c', Motion::kDown},
    {kKeyLeft, Motion::kTurnLeft}, {kKeyRight, Motion::kTurnRight},
    {kKeyUp, Motion::kTurnUp},     {kKeyDown, Motion::kTurnDown},
};

constexpr HelpLine kMotionHelp[] = {
    {"W A S D", "forward, left, back, right"},
    {"E Q", "up, down (also Space, C)"},
    {"arrows", "look; also the mouse, dragged"},
    {"Shift", "hurry"},
    {"wheel", "field of view (also PgUp, PgDn)"},
};

bool IsLetter(char32_t key) { return key >= U'a' && key <= U'z'; }

}  // namespace

std::span<const KeyBinding> KeyBindings() { return kBindings; }

std::span<const HelpLine> MotionHelp() { return kMotionHelp; }

std::optional<LiveCommand> FindCommand(const KeyEvent& event) {
  const auto found = std::ranges::find_if(kBindings, [&](const auto& row) {
    const bool shift_fits =
        !IsLetter(row.key) || row.ctrl || row.shift == event.shift;
    return row.key == event.key && row.ctrl == event.ctrl && shift_fits;
  });
  if (found == std::end(kBindings) || event.alt) return std::nullopt;
  return found->command;
}

std::optional<Motion> FindMotion(const KeyEvent& event) {
  if (event.ctrl || event.alt) return std::nullopt;
  const auto found =
      std::ranges::find(kMotions, event.key, &MotionBinding::key);
  if (found == std::end(kMotions)) return std::nullopt;
  return found->motion;
}

}  // namespace rtb
