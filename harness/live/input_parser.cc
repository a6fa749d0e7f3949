#include "harness/live/input_parser.h"

#include <algorithm>
#include <optional>

#include "encoders/parse/ansi_token.h"
#include "harness/live/input_sequences.h"

namespace rtb {
namespace {

constexpr char kEsc = '\x1b';
// Longer than any answer; a sequence without an end is no sequence.
constexpr std::size_t kLongest = 512;

/// Bytes of the UTF-8 character that begins so; 0: none begins so.
std::size_t Utf8Length(unsigned char first) {
  if (first < 0x80) return 1;
  if (first >= 0xC2 && first < 0xE0) return 2;
  if (first >= 0xE0 && first < 0xF0) return 3;
  if (first >= 0xF0 && first < 0xF5) return 4;
  return 0;
}

/// The code point of one character of the length that its first byte says.
std::optional<char32_t> Decode(std::string_view text) {
  const auto first = static_cast<unsigned char>(text[0]);
  if (text.size() == 1) return first;
  char32_t code = first & (0xFFu >> (text.size() + 1));
  for (const char c : text.substr(1)) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte & 0xC0) != 0x80) return std::nullopt;
    code = code << 6 | (byte & 0x3Fu);
  }
  return code;
}

/// Whether a string ends as it should: with ST or BEL.
bool IsTerminated(std::string_view text) {
  return text.ends_with("\x1b\\") || text.ends_with('\x07');
}

}  // namespace

std::vector<InputEvent> InputParser::Feed(std::string_view bytes) {
  buffer_ += bytes;
  std::vector<InputEvent> events;
  while (!buffer_.empty() && Step(&events)) {
  }
  return events;
}

std::vector<InputEvent> InputParser::Flush() {
  std::vector<InputEvent> events;
  if (buffer_ == std::string_view(&kEsc, 1)) {
    events.push_back(KeyEvent{.key = kKeyEscape});
  }
  buffer_.clear();
  return events;
}

bool InputParser::Step(std::vector<InputEvent>* events) {
  return buffer_[0] == kEsc ? StepEscape(events) : StepText(events);
}

bool InputParser::StepText(std::vector<InputEvent>* events) {
  const std::size_t length = Utf8Length(static_cast<unsigned char>(buffer_[0]));
  if (length > buffer_.size()) return false;
  if (length > 0) {
    const auto code = Decode(std::string_view(buffer_).substr(0, length));
    if (code) events->push_back(PlainKey(*code));
  }
  buffer_.erase(0, std::max<std::size_t>(length, 1));
  return true;
}

bool InputParser::StepEscape(std::vector<InputEvent>* events) {
  if (buffer_.size() == 1) return false;
  if (buffer_[1] == kEsc) {  // Escape, and what comes after it.
    events->push_back(KeyEvent{.key = kKeyEscape});
    buffer_.erase(0, 1);
    return true;
  }
  if (buffer_[1] == 'O') {
    if (buffer_.size() == 2) return false;
    if (const auto key = Ss3Key(buffer_[2])) events->push_back(*key);
    buffer_.erase(0, 3);
    return true;
  }
  const AnsiToken token = FirstAnsiToken(buffer_);
  // The ESC of a string's end may have come alone.
  const std::string_view rest =
      std::string_view(buffer_).substr(token.text.size());
  const bool whole = rest.empty() || (token.kind == AnsiKind::kString &&
                                      rest == std::string_view(&kEsc, 1));
  const bool open =
      token.kind == AnsiKind::kBroken ||
      (token.kind == AnsiKind::kString && !IsTerminated(token.text));
  if (whole && open && buffer_.size() < kLongest) return false;
  if (token.kind == AnsiKind::kEscape && token.intermediate.empty()) {
    KeyEvent key = PlainKey(static_cast<unsigned char>(token.final));
    key.alt = true;
    events->push_back(key);
  } else if (!open) {
    if (const auto event = EventOf(token)) events->push_back(*event);
  }
  buffer_.erase(0, token.text.size());
  return true;
}

}  // namespace rtb
