#include "core/color/srgb.h"

#include <array>
#include <cmath>

#include "core/color/srgb_scalar.h"

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

std::array<float, 256> MakeDecodeTable() {
  std::array<float, 256> table{};
  for (std::size_t i = 0; i < table.size(); ++i) {
    table[i] = static_cast<float>(Decode(static_cast<double>(i) / 255));
  }
  return table;
}

}  // namespace

float SrgbEncode(float linear) { return SrgbEncodeBy(SrgbCurve(), linear); }

float SrgbDecode(float encoded) {
  return static_cast<float>(SrgbDecode(static_cast<double>(encoded)));
}

double SrgbDecode(double encoded) { return Decode(Clip(encoded)); }

std::uint8_t SrgbEncode8(float linear) {
  return SrgbCodeBy(SrgbCodes(), linear);
}

float SrgbDecode8(std::uint8_t code) {
  static const std::array<float, 256> table = MakeDecodeTable();
  return table[code];
}

Rgb8 Encode8(const Rgb& linear) {
  const SrgbCodeTable& table = SrgbCodes();
  return {SrgbCodeBy(table, linear.x), SrgbCodeBy(table, linear.y),
          SrgbCodeBy(table, linear.z)};
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
