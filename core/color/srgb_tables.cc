#include "core/color/srgb_tables.h"

#include <cmath>

namespace rtb {
namespace {

/// Rounded half up.
std::uint32_t CodeByTheFormula(float linear) {
  return static_cast<std::uint32_t>(
      SrgbEncodeExactly(static_cast<double>(linear)) * 255 + 0.5);
}

/// The bits of the first float of [low, high] whose code is at least `code`,
/// or `high`. Codes do not fall as floats grow, and positive floats are
/// ordered as their bits are.
std::uint32_t FirstOfCode(std::uint32_t code, std::uint32_t low,
                          std::uint32_t high) {
  while (low < high) {
    const std::uint32_t middle = (low + high) / 2;
    if (CodeByTheFormula(std::bit_cast<float>(middle)) < code) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low;
}

double PowerPiece(double linear) {
  return 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

}  // namespace

double SrgbEncodeExactly(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : PowerPiece(linear);
}

SrgbCodeTable::SrgbCodeTable() {
  for (std::size_t i = 0; i < kBuckets; ++i) {
    const std::uint32_t begin = (kFirstBucket + static_cast<std::uint32_t>(i))
                                << kShift;
    const std::uint32_t end = begin + (1u << kShift);
    const std::uint32_t code = CodeByTheFormula(std::bit_cast<float>(begin));
    // Nothing above 1 is ever looked up.
    const std::uint32_t next =
        code < 255 ? FirstOfCode(code + 1, begin, end) : end;
    entries[i] = (code << kShift) + (end - next);
  }
}

const SrgbCodeTable& SrgbCodes() {
  static const SrgbCodeTable table;
  return table;
}

SrgbCurveTable::SrgbCurveTable() {
  for (std::size_t i = 0; i < kBuckets; ++i) {
    const auto first = std::bit_cast<float>(
        (kFirstBucket + static_cast<std::uint32_t>(i)) << kShift);
    start[i] = static_cast<float>(PowerPiece(static_cast<double>(first)));
  }
  for (std::size_t i = 0; i < kBucketsAnOctave; ++i) {
    reciprocal[i] = static_cast<float>(16 / (16 + static_cast<double>(i)));
  }
}

const SrgbCurveTable& SrgbCurve() {
  static const SrgbCurveTable table;
  return table;
}

}  // namespace rtb
