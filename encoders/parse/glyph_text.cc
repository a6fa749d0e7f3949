#include "encoders/parse/glyph_text.h"

#include "encoders/emit/emit.h"

namespace rtb {

bool IsGlyph(char32_t code_point) {
  const bool control =
      code_point < 0x20 || (code_point >= 0x7F && code_point < 0xA0);
  const bool surrogate = code_point >= 0xD800 && code_point < 0xE000;
  const bool noncharacter = (code_point & 0xFFFE) == 0xFFFE ||
                            (code_point >= 0xFDD0 && code_point < 0xFDF0);
  return code_point < 0x110000 && !control && !surrogate && !noncharacter;
}

std::optional<char32_t> ParseGlyph(std::string_view utf8) {
  if (utf8.empty() || utf8.size() > 4) return std::nullopt;
  const auto lead = static_cast<unsigned char>(utf8[0]);
  // A lead byte of n bytes keeps its low 7 - n bits (all 7 when alone).
  char32_t code_point = utf8.size() == 1 ? lead : lead & (0x7Fu >> utf8.size());
  for (const char byte : utf8.substr(1)) {
    code_point = code_point << 6 | (static_cast<unsigned char>(byte) & 0x3Fu);
  }
  // Whatever is not the one valid spelling does not come back the same.
  if (!IsGlyph(code_point) || Utf8(code_point) != utf8) return std::nullopt;
  return code_point;
}

}  // namespace rtb
