#include "core/base/check.h"
#include "encoders/emit/emit.h"

namespace rtb {

std::string Utf8(char32_t code_point) {
  RTB_CHECK_LT(static_cast<unsigned>(code_point), 0x110000u);
  // The Unicode Standard, section 3.9, table 3-6.
  const auto byte = [code_point](unsigned lead, unsigned shift, unsigned mask) {
    return static_cast<char>(lead | ((code_point >> shift) & mask));
  };
  if (code_point < 0x80) return {byte(0, 0, 0x7F)};
  if (code_point < 0x800) return {byte(0xC0, 6, 0x1F), byte(0x80, 0, 0x3F)};
  if (code_point < 0x10000) {
    return {byte(0xE0, 12, 0x0F), byte(0x80, 6, 0x3F), byte(0x80, 0, 0x3F)};
  }
  return {byte(0xF0, 18, 0x07), byte(0x80, 12, 0x3F), byte(0x80, 6, 0x3F),
          byte(0x80, 0, 0x3F)};
}

}  // namespace rtb
