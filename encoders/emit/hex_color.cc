#include "encoders/emit/hex_color.h"

#include <charconv>
#include <cstdio>

namespace rtb {

std::string HexColor(Rgb8 color) {
  char text[8];
  std::snprintf(text, sizeof text, "#%02x%02x%02x", color.r, color.g, color.b);
  return text;
}

std::optional<Rgb8> ParseHexColor(std::string_view text) {
  if (text.size() != 7 || text[0] != '#') return std::nullopt;
  unsigned value = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data() + 1, end, value, 16);
  if (error != std::errc() || stop != end) return std::nullopt;
  return Rgb8{static_cast<std::uint8_t>(value >> 16),
              static_cast<std::uint8_t>(value >> 8),
              static_cast<std::uint8_t>(value)};
}

}  // namespace rtb
