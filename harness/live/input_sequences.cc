#include "harness/live/input_sequences.h"

#include <algorithm>
#include <string>
#include <vector>

#include "core/base/numbers.h"

namespace rtb {
namespace {

/// One parameter: its numbers, which colons separate; 0 where there is none.
using Parameter = std::vector<int>;

std::vector<std::string_view> Split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  while (true) {
    const std::size_t end = text.find(separator);
    parts.push_back(text.substr(0, end));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

std::vector<Parameter> ReadParameters(std::string_view body) {
  std::vector<Parameter> parameters;
  for (const std::string_view part : Split(body, ';')) {
    Parameter numbers;
    for (const std::string_view number : Split(part, ':')) {
      numbers.push_back(std::max(0, ParseWhole<int>(number).value_or(0)));
    }
    parameters.push_back(numbers);
  }
  return parameters;
}

/// Number `sub` of parameter `index`, 0 where there is none.
int At(const std::vector<Parameter>& parameters, std::size_t index,
       std::size_t sub = 0) {
  if (index >= parameters.size()) return 0;
  return sub < parameters[index].size() ? parameters[index][sub] : 0;
}

/// Modifiers and action of a key: `1 + bits : action`. Caps Lock and Num Lock
/// are bits too, and mean nothing.
KeyEvent WithModifiers(char32_t key, const std::vector<Parameter>& parameters) {
  const int bits = std::max(At(parameters, 1) - 1, 0);
  KeyEvent event{.key = key};
  event.shift = (bits & 1) != 0;
  event.alt = (bits & 2) != 0;
  event.ctrl = (bits & 4) != 0;
  const int action = At(parameters, 1, 1);
  if (action == 2) event.action = KeyAction::kRepeat;
  if (action == 3) event.action = KeyAction::kRelease;
  return event;
}

/// The key of a legacy sequence's last byte; 0 for none.
char32_t LetterKey(char final) {
  switch (final) {
    case 'A':
      return kKeyUp;
    case 'B':
      return kKeyDown;
    case 'C':
      return kKeyRight;
    case 'D':
      return kKeyLeft;
    case 'F':
      return kKeyEnd;
    case 'H':
      return kKeyHome;
    default:
      return 0;
  }
}

/// The key of `CSI number ~`; 0 for none.
char32_t TildeKey(int number) {
  switch (number) {
    case 1:
    case 7:
      return kKeyHome;
    case 4:
    case 8:
      return kKeyEnd;
    case 5:
      return kKeyPageUp;
    case 6:
      return kKeyPageDown;
    default:
      return 0;
  }
}

/// `CSI code:shifted ; modifiers:action u`, kitty's keys.
std::optional<InputEvent> KittyKey(const std::vector<Parameter>& parameters) {
  constexpr int kLeftShift = 57441, kRightShift = 57447, kEnter = 57414;
  // The rest of kitty's own keys, in Unicode's private use area.
  constexpr int kFirstOwn = 57344, kLastOwn = 63743;
  int code = At(parameters, 0);
  KeyEvent event = WithModifiers(0, parameters);
  if (event.shift && At(parameters, 0, 1) != 0) code = At(parameters, 0, 1);
  if (code == kLeftShift || code == kRightShift) {
    event.key = kKeyShift;
    return event;
  }
  if (code == kEnter) code = static_cast<int>(kKeyEnter);
  if (code <= 0 || code > 0x10FFFF) return std::nullopt;
  if (code >= kFirstOwn && code <= kLastOwn) return std::nullopt;
  const KeyEvent plain = PlainKey(static_cast<char32_t>(code));
  event.key = plain.key;
  event.shift = event.shift || plain.shift;
  return event;
}

/// `CSI < button ; column ; row M` or `m`.
std::optional<InputEvent> Mouse(std::string_view body, char final) {
  const auto parameters = ReadParameters(body.substr(1));
  if (parameters.size() != 3) return std::nullopt;
  const int code = At(parameters, 0);
  MouseEvent event;
  event.button = code & 3;
  event.column = std::max(At(parameters, 1) - 1, 0);
  event.row = std::max(At(parameters, 2) - 1, 0);
  if ((code & 64) != 0) {
    if (event.button > 1) return std::nullopt;  // Sideways.
    event.action =
        event.button == 0 ? MouseAction::kWheelUp : MouseAction::kWheelDown;
    event.button = 0;
  } else if (final == 'm') {
    event.action = MouseAction::kRelease;
  } else if ((code & 32) != 0) {
    event.action = MouseAction::kDrag;
  }
  return event;
}

ReplyEvent Reply(ReplyEvent::Kind kind, int number = 0, std::string text = {}) {
  return {kind, number, std::move(text)};
}

/// What begins with `CSI ?` answers a question.
std::optional<InputEvent> PrivateReply(const AnsiToken& token) {
  const auto parameters = ReadParameters(token.body.substr(1));
  if (token.final == 'y' && token.intermediate == "$") {
    if (At(parameters, 0) != 2026) return std::nullopt;
    return Reply(ReplyEvent::Kind::kSyncMode, At(parameters, 1));
  }
  if (token.IsCsi('c')) return Reply(ReplyEvent::Kind::kAttributes);
  if (token.IsCsi('u')) {
    return Reply(ReplyEvent::Kind::kKeyboard, At(parameters, 0));
  }
  return std::nullopt;
}

/// Device control strings: DECRQSS and XTVERSION.
std::optional<InputEvent> StringReply(const AnsiToken& token) {
  if (token.final != 'P') return std::nullopt;
  if (token.body.starts_with("1$r")) {
    return Reply(ReplyEvent::Kind::kColors, 0,
                 std::string(token.body.substr(3)));
  }
  if (token.body.starts_with(">|")) {
    return Reply(ReplyEvent::Kind::kVersion, 0,
                 std::string(token.body.substr(2)));
  }
  return std::nullopt;
}

}  // namespace

KeyEvent PlainKey(char32_t code) {
  KeyEvent event{.key = code};
  if (code >= U'A' && code <= U'Z') {
    event.key = code - U'A' + U'a';
    event.shift = true;
  } else if (code == 8) {
    event.key = kKeyBackspace;
  } else if (code == 10) {
    event.key = kKeyEnter;
  } else if (code < 32 && code != kKeyTab && code != kKeyEnter &&
             code != kKeyEscape) {
    event.ctrl = true;
    event.key = code <= 26 ? code - 1 + U'a' : code + 64;
    if (code == 0) event.key = U' ';
  }
  return event;
}

std::optional<KeyEvent> Ss3Key(char final) {
  const char32_t key = LetterKey(final);
  if (key == 0) return std::nullopt;
  return KeyEvent{.key = key};
}

std::optional<InputEvent> EventOf(const AnsiToken& token) {
  if (token.kind == AnsiKind::kString) return StringReply(token);
  if (token.kind != AnsiKind::kCsi) return std::nullopt;
  if (token.body.starts_with('?')) return PrivateReply(token);
  if (token.body.starts_with('<')) {
    if (!token.IsCsi('M') && !token.IsCsi('m')) return std::nullopt;
    return Mouse(token.body, token.final);
  }
  const auto parameters = ReadParameters(token.body);
  if (token.IsCsi('n') && At(parameters, 0) == 0) {
    return Reply(ReplyEvent::Kind::kStatus);
  }
  if (token.IsCsi('t') && At(parameters, 0) == 6) {
    return Reply(ReplyEvent::Kind::kCellSize, At(parameters, 2),
                 std::to_string(At(parameters, 1)));
  }
  if (token.IsCsi('u')) return KittyKey(parameters);
  if (token.IsCsi('Z')) return KeyEvent{.key = kKeyTab, .shift = true};
  const char32_t key = token.IsCsi('~') ? TildeKey(At(parameters, 0))
                       : token.intermediate.empty() ? LetterKey(token.final)
                                                    : 0;
  if (key == 0) return std::nullopt;
  return WithModifiers(key, parameters);
}

}  // namespace rtb
