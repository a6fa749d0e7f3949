/// @file
/// The sRGB transfer functions (IEC 61966-2-1) and 8-bit display colors.
#pragma once

#include <compare>
#include <cstdint>
#include <span>

#include "core/math/vec.h"

namespace rtb {

/// A display color: 8-bit sRGB-encoded components.
struct Rgb8 {
  std::uint8_t r = 0;
  std::uint8_t g = 0;
  std::uint8_t b = 0;
  auto operator<=>(const Rgb8&) const = default;
};

/// Linear [0, 1] to encoded [0, 1], within 1e-7 of the formula in double
/// precision; clips, NaN becomes 0.
float SrgbEncode(float linear);
/// Encoded [0, 1] to linear [0, 1]; clips, NaN becomes 0.
float SrgbDecode(float encoded);
/// The same in double precision, for metrics.
double SrgbDecode(double encoded);

/// Linear to an 8-bit code: clipped, encoded, rounded half up; NaN becomes 0.
std::uint8_t SrgbEncode8(float linear);
/// An 8-bit code to linear; SrgbEncode8 is its exact inverse on codes.
float SrgbDecode8(std::uint8_t code);

/// The same for colors.
Rgb8 Encode8(const Rgb& linear);
Rgb Decode8(Rgb8 color);

/// @name Many at once: the same results, by vectors.
/// Both spans have one length; they may be the same, but not overlap otherwise.
/// @{
void SrgbEncode(std::span<const float> linear, std::span<float> encoded);
void SrgbEncode(std::span<const Rgb> linear, std::span<Rgb> encoded);
void Encode8(std::span<const Rgb> linear, std::span<Rgb8> codes);
/// @}

/// code / 255 of each component: encoded values in [0, 1].
Rgb EncodedValues(Rgb8 color);

/// An encoded value in [0, 1] to its code, rounded half up; NaN becomes 0.
std::uint8_t QuantizeEncoded(float encoded);
Rgb8 QuantizeEncoded(const Rgb& encoded);

}  // namespace rtb
