#include "encoders/parse/ansi_token.h"

#include <algorithm>
#include <cstddef>

namespace rtb {
namespace {

constexpr char kEscapeByte = '\x1b';

bool Between(char c, char low, char high) { return c >= low && c <= high; }
bool IsPrintable(char c) {
  return static_cast<unsigned char>(c) >= 0x20 && c != '\x7f';
}
bool IsParameter(char c) { return Between(c, '0', '?'); }
bool IsIntermediate(char c) { return Between(c, ' ', '/'); }

/// The first position from `begin` on that `accepts` does not take.
template <class Predicate>
std::size_t Skip(std::string_view text, std::size_t begin, Predicate accepts) {
  while (begin < text.size() && accepts(text[begin])) ++begin;
  return begin;
}

AnsiToken Broken(std::string_view text, std::size_t length) {
  return {AnsiKind::kBroken, text.substr(0, length), {}, {}, 0};
}

/// From the intermediate bytes at `begin` on: the rest of kEscape and kCsi.
AnsiToken Finish(std::string_view text, std::size_t begin, char lowest_final,
                 AnsiToken token) {
  const std::size_t end = Skip(text, begin, IsIntermediate);
  if (end == text.size() || !Between(text[end], lowest_final, '~')) {
    return Broken(text, end);
  }
  token.intermediate = text.substr(begin, end - begin);
  token.final = text[end];
  token.text = text.substr(0, end + 1);
  return token;
}

AnsiToken Csi(std::string_view text) {
  const std::size_t end = Skip(text, 2, IsParameter);
  return Finish(text, end, '@',
                {AnsiKind::kCsi, {}, text.substr(2, end - 2), {}, 0});
}

/// Ends with ST (ESC \) or BEL; CAN, SUB and any other ESC break it off.
AnsiToken String(std::string_view text) {
  const std::size_t end =
      std::min(text.find_first_of("\x07\x18\x1a\x1b", 2), text.size());
  AnsiToken token{AnsiKind::kString, {}, text.substr(2, end - 2), {}, text[1]};
  const std::string_view rest = text.substr(end);
  const std::size_t terminator = rest.starts_with("\x1b\\")      ? 2
                                 : rest.starts_with(kEscapeByte) ? 0
                                                                 : 1;
  token.text = text.substr(0, std::min(end + terminator, text.size()));
  return token;
}

}  // namespace

AnsiToken FirstAnsiToken(std::string_view text) {
  if (IsPrintable(text[0])) {
    const std::size_t end = Skip(text, 1, IsPrintable);
    return {AnsiKind::kText, text.substr(0, end), {}, {}, 0};
  }
  if (text[0] != kEscapeByte) {
    return {AnsiKind::kControl, text.substr(0, 1), {}, {}, text[0]};
  }
  if (text.size() == 1) return Broken(text, 1);
  if (text[1] == '[') return Csi(text);
  constexpr std::string_view kStrings = "P]_^X";
  if (kStrings.find(text[1]) != std::string_view::npos) return String(text);
  return Finish(text, 1, '0', {AnsiKind::kEscape, {}, {}, {}, 0});
}

}  // namespace rtb
