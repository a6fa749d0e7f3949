#include "core/color/srgb.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "core/color/srgb_tables.h"

namespace rtb {
namespace {

double Decode(double v) {
  return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

/// Clips to [0, 1]; NaN becomes 0.
double Clip(double value) {
  if (!(value > 0)) return 0;
  return value < 1 ? value : 1.0;
}

std::uint8_t CodeOf(float linear, const SrgbCodeTable& table) {
  using T = SrgbCodeTable;
  // In this order of arguments NaN becomes black.
  const float x = std::min(std::max(T::kDarkest, linear), 1.0f);
  const auto bits = std::bit_cast<std::uint32_t>(x);
  const std::uint32_t entry =
      table.entries[(bits >> T::kShift) - T::kFirstBucket];
  return static_cast<std::uint8_t>((entry + (bits & T::kRest)) >> T::kShift);
}

std::array<float, 256> MakeDecodeTable() {
  std::array<float, 256> table{};
  for (std::size_t i = 0; i < table.size(); ++i) {
    table[i] = static_cast<float>(Decode(static_cast<double>(i) / 255));
  }
  return table;
}

}  // namespace

// The very operations of SrgbCurveOf in srgb-inl.h.
float SrgbEncode(float linear) {
  using T = SrgbCurveTable;
  const float x = linear > 0 ? std::min(linear, 1.0f) : 0.0f;
  if (x <= T::kKnee) return T::kSlope * x;
  const SrgbCurveTable& table = SrgbCurve();
  const auto bits = std::bit_cast<std::uint32_t>(x);
  const std::uint32_t leading = bits >> T::kShift;
  const float start = table.start[leading - T::kFirstBucket];
  const std::uint32_t mantissa =
      (bits & 0x7fffff) | std::bit_cast<std::uint32_t>(1.0f);
  const std::uint32_t first = mantissa & ~((1u << T::kShift) - 1);
  const float e =
      (std::bit_cast<float>(mantissa) - std::bit_cast<float>(first)) *
      table.reciprocal[leading % T::kBucketsAnOctave];
  const float c = (T::kC3 * e + T::kC2) * e + T::kC1;
  return start + (start + T::kOffset) * (c * e);
}

float SrgbDecode(float encoded) {
  return static_cast<float>(SrgbDecode(static_cast<double>(encoded)));
}

double SrgbDecode(double encoded) { return Decode(Clip(encoded)); }

std::uint8_t SrgbEncode8(float linear) { return CodeOf(linear, SrgbCodes()); }

float SrgbDecode8(std::uint8_t code) {
  static const std::array<float, 256> table = MakeDecodeTable();
  return table[code];
}

Rgb8 Encode8(const Rgb& linear) {
  const SrgbCodeTable& table = SrgbCodes();
  return {CodeOf(linear.x, table), CodeOf(linear.y, table),
          CodeOf(linear.z, table)};
}

Rgb Decode8(Rgb8 color) {
  return {SrgbDecode8(color.r), SrgbDecode8(color.g), SrgbDecode8(color.b)};
}

Rgb EncodedValues(Rgb8 color) {
  return {static_cast<float>(color.r) / 255, static_cast<float>(color.g) / 255,
          static_cast<float>(color.b) / 255};
}

std::uint8_t QuantizeEncoded(float encoded) {
  return static_cast<std::uint8_t>(Clip(encoded) * 255 + 0.5);
}

Rgb8 QuantizeEncoded(const Rgb& encoded) {
  return {QuantizeEncoded(encoded.x), QuantizeEncoded(encoded.y),
          QuantizeEncoded(encoded.z)};
}

}  // namespace rtb
