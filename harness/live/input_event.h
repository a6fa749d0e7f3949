/// @file
/// What comes in from a terminal: keys, the mouse, and answers to questions.
#pragma once

#include <string>
#include <variant>

namespace rtb {

/// @name Keys: their character (letters in lower case), or one of these.
/// @{
inline constexpr char32_t kKeyTab = 9;
inline constexpr char32_t kKeyEnter = 13;
inline constexpr char32_t kKeyEscape = 27;
inline constexpr char32_t kKeyBackspace = 127;
inline constexpr char32_t kKeyUp = 0x110000;  // Above Unicode.
inline constexpr char32_t kKeyDown = 0x110001;
inline constexpr char32_t kKeyRight = 0x110002;
inline constexpr char32_t kKeyLeft = 0x110003;
inline constexpr char32_t kKeyPageUp = 0x110004;
inline constexpr char32_t kKeyPageDown = 0x110005;
inline constexpr char32_t kKeyHome = 0x110006;
inline constexpr char32_t kKeyEnd = 0x110007;
inline constexpr char32_t kKeyShift = 0x110008;  ///< Itself, by kitty's rules.
/// @}

enum class KeyAction { kPress, kRepeat, kRelease };

/// A key. Terminals without kitty's protocol know presses alone.
struct KeyEvent {
  char32_t key = 0;
  KeyAction action = KeyAction::kPress;
  bool shift = false;
  bool alt = false;
  bool ctrl = false;
  bool operator==(const KeyEvent&) const = default;
};

enum class MouseAction { kPress, kRelease, kDrag, kWheelUp, kWheelDown };

/// The mouse; cells count from 0.
struct MouseEvent {
  MouseAction action = MouseAction::kPress;
  int button = 0;  ///< 0 left, 1 middle, 2 right.
  int column = 0;
  int row = 0;
  bool operator==(const MouseEvent&) const = default;
};

/// An answer of the terminal.
struct ReplyEvent {
  enum class Kind {
    kAttributes,  ///< DA1: what every terminal answers.
    kStatus,      ///< DSR 5: all that came before has been drawn.
    kSyncMode,    ///< DECRPM of mode 2026; number: its state.
    kKeyboard,    ///< kitty's keyboard flags: the protocol is there.
    kColors,      ///< DECRQSS of SGR; text: the parameters.
    kVersion,     ///< XTVERSION; text: name and version.
    kCellSize,    ///< Pixels of a cell: number x text.
  };
  Kind kind = Kind::kStatus;
  int number = 0;
  std::string text = {};
  bool operator==(const ReplyEvent&) const = default;
};

using InputEvent = std::variant<KeyEvent, MouseEvent, ReplyEvent>;

}  // namespace rtb
