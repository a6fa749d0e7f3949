/// @file
/// Font: coverage masks from a font file. Only font.cc knows FreeType.
#pragma once

#include <filesystem>
#include <memory>

#include "core/base/result.h"
#include "encoders/glyphs/mask.h"

namespace rtb {

/// A scalable font, opened. Not safe to share between threads.
class Font {
 public:
  /// @return kBadInput for a file that is no scalable font, or cannot be read.
  static Result<std::unique_ptr<Font>> Open(const std::filesystem::path& file);
  ~Font();

  /// Whether the font can draw the code point.
  bool Has(char32_t glyph) const;

  /// The glyph's gray coverage, unhinted, at the size at which its advance
  /// equals the cell's width; ascender and descender of the font share the
  /// rest of the cell's height evenly (which is negative in low cells). What
  /// reaches out of the cell is clipped.
  /// @return kFailure when the font is broken there or the glyph has no width.
  Result<Mask> Render(char32_t glyph, int width, int height) const;

 private:
  struct Face;
  Font(std::unique_ptr<Face> face, std::filesystem::path file);

  std::unique_ptr<Face> face_;
  std::filesystem::path file_;
};

/// `U+259F`.
std::string CodePointName(char32_t glyph);

}  // namespace rtb
