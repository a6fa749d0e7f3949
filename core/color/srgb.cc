#include "core/color/srgb.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

namespace rtb {
namespace {

/// IEC 61966-2-1, in double precision; `l` in [0, 1].
double Encode(double l) {
  return l <= 0.0031308 ? 12.92 * l : 1.055 * std::pow(l, 1 / 2.4) - 0.055;
}

double Decode(double v) {
  return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

/// Clips to [0, 1]; NaN becomes 0.
double Clip(double value) {
  if (!(value > 0)) return 0;
  return value < 1 ? value : 1.0;
}

/// What SrgbEncode8 answers; it gets there without the power.
int EncodeCode(float linear) {
  return static_cast<int>(Encode(Clip(linear)) * 255 + 0.5);
}

/// The smallest float whose code is at least `code`. Codes do not fall as
/// floats grow, and positive floats are ordered as their bits are.
float FirstOfCode(int code) {
  std::uint32_t low = 0;
  std::uint32_t high = std::bit_cast<std::uint32_t>(1.0f);
  while (low < high) {
    const std::uint32_t middle = (low + high) / 2;
    if (EncodeCode(std::bit_cast<float>(middle)) < code) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return std::bit_cast<float>(low);
}

/// Codes of floats by comparison alone. [kDarkest, 1] falls into buckets of
/// equal leading bits, 128 an octave. A code takes up at least 1/84 of the
/// start of the octave that it lies in, so no bucket sees more than two codes.
class EncodeTable {
 public:
  EncodeTable() {
    for (std::size_t i = 0; i < kBuckets; ++i) {
      const auto bits = static_cast<std::uint32_t>(i + kFirstBucket) << kShift;
      code_at_start_[i] =
          static_cast<std::uint8_t>(EncodeCode(std::bit_cast<float>(bits)));
    }
    for (std::size_t code = 0; code < 256; ++code) {
      first_[code] = FirstOfCode(static_cast<int>(code));
    }
    first_[256] = std::numeric_limits<float>::infinity();
  }

  std::uint8_t Code(float linear) const {
    // In this order of arguments NaN becomes black.
    linear = std::min(std::max(kDarkest, linear), 1.0f);
    const std::uint8_t code = code_at_start_[Bucket(linear)];
    return static_cast<std::uint8_t>(code + (linear >= first_[code + 1u]));
  }

 private:
  static constexpr float kDarkest = 0x1p-13f;  ///< Still black.
  static constexpr int kShift = 23 - 7;  ///< Leaves 7 bits of the mantissa.
  static constexpr std::size_t kFirstBucket =
      std::bit_cast<std::uint32_t>(kDarkest) >> kShift;
  static constexpr std::size_t kBuckets =
      (std::bit_cast<std::uint32_t>(1.0f) >> kShift) - kFirstBucket + 1;

  static std::size_t Bucket(float linear) {
    return (std::bit_cast<std::uint32_t>(linear) >> kShift) - kFirstBucket;
  }

  std::array<std::uint8_t, kBuckets> code_at_start_;
  std::array<float, 257> first_;  ///< The smallest float of each code.
};

const EncodeTable& Codes() {
  static const EncodeTable table;
  return table;
}

std::array<float, 256> MakeDecodeTable() {
  std::array<float, 256> table{};
  for (std::size_t i = 0; i < table.size(); ++i) {
    table[i] = static_cast<float>(Decode(static_cast<double>(i) / 255));
  }
  return table;
}

}  // namespace

float SrgbEncode(float linear) {
  return static_cast<float>(Encode(Clip(linear)));
}

float SrgbDecode(float encoded) {
  return static_cast<float>(SrgbDecode(static_cast<double>(encoded)));
}

double SrgbDecode(double encoded) { return Decode(Clip(encoded)); }

std::uint8_t SrgbEncode8(float linear) { return Codes().Code(linear); }

float SrgbDecode8(std::uint8_t code) {
  static const std::array<float, 256> table = MakeDecodeTable();
  return table[code];
}

Rgb8 Encode8(const Rgb& linear) {
  const EncodeTable& codes = Codes();
  return {codes.Code(linear.x), codes.Code(linear.y), codes.Code(linear.z)};
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
