/// @file
/// Atlas: the glyphs that an encoder may choose from, with their coverage
/// masks prepared for least squares. GlyphSet -> Atlas -> FitCell.
#pragma once

#include <filesystem>
#include <span>
#include <unordered_map>
#include <vector>

#include "core/base/result.h"
#include "encoders/glyphs/glyph_set.h"

namespace rtb {

/// A mask with the sums of the normal equations that do not depend on the
/// picture. m is the coverage, n the number of sub-pixels.
struct FitMask {
  char32_t glyph = U' ';
  std::vector<double> coverage;  ///< In [0, 1], row by row from the top left.
  double sum = 0;                ///< Of m.
  double sum_squares = 0;        ///< Of m^2.
  /// Of (m - mean m)^2: 0 exactly when the mask is constant.
  double variance = 0;
  /// Index in the Atlas of the candidate of a lower code point that covers
  /// just what this one leaves free; -1 without such.
  int complement = -1;

  double size() const { return static_cast<double>(coverage.size()); }
  /// Every coverage the same, as in a space, a full block and the shades.
  bool constant() const { return variance == 0; }
  /// Every coverage either 0 or 1: the two colors do not depend on each other.
  bool binary() const { return sum == sum_squares; }
};

/// Prepares one mask. Coverages that differ by less than single precision can
/// tell count as constant.
FitMask MakeFitMask(char32_t glyph, const Mask& mask);

/// The candidates at one cell size. Immutable; safe to share between threads.
class Atlas {
 public:
  int width() const { return width_; }    ///< Sub-pixels.
  int height() const { return height_; }  ///< Sub-pixels.

  /// One mask each, by rising code point. Of glyphs whose masks are equal the
  /// lowest code point stands for all.
  std::span<const FitMask> candidates() const { return candidates_; }

  /// The candidates' code points.
  std::vector<char32_t> glyphs() const;

  /// Index of the candidate that looks like the glyph; -1 when the glyph is
  /// not in the atlas.
  int Find(char32_t glyph) const;

 private:
  friend Result<Atlas> MakeAtlas(std::span<const char32_t> glyphs, int width,
                                 int height, MaskSource source,
                                 const std::filesystem::path& font);
  Atlas(int width, int height) : width_(width), height_(height) {}
  void Add(FitMask mask);

  int width_;
  int height_;
  std::vector<FitMask> candidates_;
  std::unordered_map<char32_t, int> index_;  ///< By glyph.
};

/// Makes an atlas of masks of width x height sub-pixels.
/// @param glyphs rising code points, at least one (GlyphsOf makes them).
/// @param font empty: DejaVu Sans Mono.
/// @return the errors of GlyphSet::Get.
Result<Atlas> MakeAtlas(std::span<const char32_t> glyphs, int width, int height,
                        MaskSource source = MaskSource::kGeometric,
                        const std::filesystem::path& font = {});

}  // namespace rtb
