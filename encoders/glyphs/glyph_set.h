/// @file
/// GlyphSet: the coverage masks of glyphs at one cell size.
#pragma once

#include <filesystem>
#include <memory>
#include <mutex>
#include <unordered_map>
#include <vector>

#include "core/base/result.h"
#include "encoders/glyphs/font.h"
#include "encoders/glyphs/mask.h"

namespace rtb {

/// Where the coverage masks of glyphs come from.
enum class MaskSource {
  kGeometric,  ///< Exact areas where Unicode defines them, else the font.
  kFont,       ///< The font for every glyph: many draw blocks with gaps.
};

/// The fonts that are tried in order: the given one, then DejaVu Sans Mono,
/// then DejaVu Sans (which has the braille patterns that its monospaced
/// sibling lacks).
std::vector<std::filesystem::path> FontChain(const std::filesystem::path& font);

/// Masks made when first asked for, then kept. A glyph that no font of the
/// chain has takes its geometric mask even under kFont, as terminals draw it
/// themselves. Safe to share between threads.
class GlyphSet {
 public:
  /// Masks of width x height sub-pixels. Fonts are opened when a glyph needs
  /// them, not before.
  /// @param font empty: DejaVu Sans Mono.
  GlyphSet(int width, int height, MaskSource source,
           const std::filesystem::path& font = {});

  int width() const { return width_; }
  int height() const { return height_; }

  /// The mask of a glyph; lives as long as the set.
  /// @return kMissing when DejaVu is not installed or no font has the glyph,
  /// kBadInput when the given font cannot be used.
  Result<const Mask*> Get(char32_t glyph);

 private:
  /// A font that was looked for: open, or why it is not.
  using OpenFont = Result<std::unique_ptr<Font>>;

  Result<Mask> Make(char32_t glyph);
  Result<const Font*> FindFont(char32_t glyph);
  const OpenFont& FontAt(std::size_t index);

  int width_;
  int height_;
  MaskSource source_;
  std::vector<std::filesystem::path> chain_;
  std::mutex mutex_;
  std::vector<OpenFont> fonts_;  ///< The first of chain_, as far as needed.
  std::unordered_map<char32_t, Mask> masks_;
};

}  // namespace rtb
