#include "core/scene/yaml_text.h"

#include <cstddef>
#include <string_view>

#include "core/scene/yaml_tree.h"

namespace rtb {
namespace {

unsigned char ByteAt(std::string_view text, std::size_t i) {
  return i < text.size() ? static_cast<unsigned char>(text[i]) : 0;
}

bool IsTail(std::string_view text, std::size_t i) {
  return (ByteAt(text, i) & 0xC0) == 0x80;
}

/// The length of the well-formed UTF-8 sequence that begins at `i`, or 0: RFC
/// 3629, section 4 (no overlong forms, no surrogates, at most U+10FFFF).
std::size_t Utf8Length(std::string_view text, std::size_t i) {
  const unsigned char lead = ByteAt(text, i);
  const unsigned char second = ByteAt(text, i + 1);
  if (lead < 0x80) return 1;
  if (lead < 0xC2 || lead > 0xF4 || !IsTail(text, i + 1)) return 0;
  if (lead < 0xE0) return 2;
  if (!IsTail(text, i + 2)) return 0;
  if (lead == 0xE0 && second < 0xA0) return 0;
  if (lead == 0xED && second > 0x9F) return 0;
  if (lead < 0xF0) return 3;
  if (!IsTail(text, i + 3)) return 0;
  if (lead == 0xF0 && second < 0x90) return 0;
  if (lead == 0xF4 && second > 0x8F) return 0;
  return 4;
}

bool IsControl(unsigned char c) {
  return (c < 0x20 && c != '\t' && c != '\n' && c != '\r') || c == 0x7F;
}

}  // namespace

Status CheckYamlText(const std::string& text, const std::string& file) {
  if (text.size() > kMaxYamlBytes) {
    return Fail(BadInput(file, "the text has " + std::to_string(text.size()) +
                                   " bytes, expected at most " +
                                   std::to_string(kMaxYamlBytes)));
  }
  SourceMark mark{1, 1};
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = Utf8Length(text, i);
    if (length == 0) {
      return Fail(BadInput(PlaceOf(file, mark), "the text is not UTF-8",
                           "is this a scene file, saved as UTF-8?"));
    }
    if (IsControl(ByteAt(text, i))) {
      return Fail(BadInput(
          PlaceOf(file, mark),
          "control character " + Printable(text.substr(i, 1)) + " in the text",
          "is this a scene file?"));
    }
    mark = text[i] == '\n' ? SourceMark{mark.line + 1, 1}
                           : SourceMark{mark.line, mark.column + 1};
    i += length;
  }
  return {};
}

}  // namespace rtb
