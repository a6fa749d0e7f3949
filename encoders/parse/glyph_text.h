/// @file
/// Which code points a cell may hold, and reading one from text.
#pragma once

#include <optional>
#include <string_view>

namespace rtb {

/// Whether a cell may hold the code point: no control character, surrogate or
/// noncharacter, so that nothing a grid was read from can reach a terminal as
/// an escape sequence.
bool IsGlyph(char32_t code_point);

/// The glyph of a string that is one code point of valid UTF-8.
std::optional<char32_t> ParseGlyph(std::string_view utf8);

}  // namespace rtb
