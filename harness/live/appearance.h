/// @file
/// How different two cells look, whatever glyph and colors they are made of.
#pragma once

#include <array>
#include <optional>
#include <unordered_map>

#include "encoders/cell.h"

namespace rtb {

/// Compares cells by 2 x 4 parts: the colors that glyphs with a geometric
/// shape show there. Keeps the shapes it has seen.
class AppearanceTable {
 public:
  /// RMS over parts and channels of the difference of 8-bit values; infinite
  /// where two cells differ in a character that is no geometric shape.
  float Difference(const Cell& a, const Cell& b);

 private:
  static constexpr int kColumns = 2;
  static constexpr int kRows = 4;
  /// Coverage of each part.
  using Coverage = std::array<float, kColumns * kRows>;

  const std::optional<Coverage>& CoverageOf(char32_t glyph);

  std::unordered_map<char32_t, std::optional<Coverage>> seen_;
};

}  // namespace rtb
