#include "harness/results/display_width.h"

#include <algorithm>
#include <cstddef>
#include <span>

namespace rtb {
namespace {

struct Range {
  char32_t first, last;
};

constexpr Range kZeroWidth[] = {
    {0x0300, 0x036F}, {0x1AB0, 0x1AFF}, {0x1DC0, 0x1DFF}, {0x200B, 0x200F},
    {0x20D0, 0x20FF}, {0xFE00, 0xFE0F}, {0xFE20, 0xFE2F}};
constexpr Range kWide[] = {
    {0x1100, 0x115F},   {0x2E80, 0x303E},   {0x3041, 0xA4CF},  {0xAC00, 0xD7A3},
    {0xF900, 0xFAFF},   {0xFE30, 0xFE6F},   {0xFF00, 0xFF60},  {0xFFE0, 0xFFE6},
    {0x1F300, 0x1F64F}, {0x1F900, 0x1F9FF}, {0x20000, 0x3FFFD}};

bool Contains(std::span<const Range> ranges, char32_t c) {
  return std::ranges::any_of(
      ranges, [c](Range r) { return r.first <= c && c <= r.last; });
}

/// Bytes of the sequence that a lead byte announces.
std::size_t SequenceLength(unsigned char lead) {
  if (lead >= 0xF0 && lead < 0xF8) return 4;
  if (lead >= 0xE0 && lead < 0xF0) return 3;
  if (lead >= 0xC0 && lead < 0xE0) return 2;
  return 1;
}

/// Takes one code point, or one byte that starts none, off the front.
char32_t TakeCodePoint(std::string_view& text) {
  const auto byte = [&](std::size_t i) {
    return static_cast<unsigned char>(text[i]);
  };
  const std::size_t length = SequenceLength(byte(0));
  char32_t code = byte(0) & (length == 1 ? 0xFFu : 0xFFu >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) {
    if (i >= text.size() || (byte(i) & 0xC0) != 0x80) {
      text.remove_prefix(1);
      return U'?';
    }
    code = code << 6 | (byte(i) & 0x3Fu);
  }
  text.remove_prefix(length);
  return code;
}

}  // namespace

int DisplayWidth(std::string_view utf8) {
  int width = 0;
  while (!utf8.empty()) {
    const char32_t code = TakeCodePoint(utf8);
    if (Contains(kZeroWidth, code)) continue;
    width += Contains(kWide, code) ? 2 : 1;
  }
  return width;
}

}  // namespace rtb
