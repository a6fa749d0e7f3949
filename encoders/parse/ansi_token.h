/// @file
/// The pieces that text for a terminal is made of.
#pragma once

#include <string_view>

namespace rtb {

/// What a piece is. ECMA-48, sections 5 and 8.3; the states are those of
/// vt100.net's parser for DEC terminals.
enum class AnsiKind {
  kText,     ///< Printable bytes, of UTF-8 too.
  kControl,  ///< One C0 control or DEL.
  kEscape,   ///< ESC, intermediate bytes, a final byte.
  kCsi,      ///< ESC [, parameters, intermediate bytes, a final byte.
  kString,   ///< A DCS, OSC, APC, PM or SOS with all that it holds.
  kBroken,   ///< The beginning of a sequence that does not go on.
};

/// One piece of a text, which must outlive it.
struct AnsiToken {
  AnsiKind kind = AnsiKind::kText;
  std::string_view text;          ///< All of it.
  std::string_view body;          ///< A CSI's parameters, a string's content.
  std::string_view intermediate;  ///< Of kEscape and kCsi.
  /// A control, or the last byte of kEscape and kCsi; the byte after ESC that
  /// began a kString.
  char final = 0;

  /// Whether it is a CSI without intermediate bytes that ends in `last`.
  bool IsCsi(char last) const {
    return kind == AnsiKind::kCsi && intermediate.empty() && final == last;
  }
};

/// The first piece of a text that is not empty; at least one byte of it.
AnsiToken FirstAnsiToken(std::string_view text);

}  // namespace rtb
