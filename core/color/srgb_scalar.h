/// @file
/// The sRGB transfer of single values by the tables of srgb_tables.h, host and
/// device: the very operations of srgb-inl.h.
#pragma once

#include <bit>
#include <cstdint>

#include "core/base/host_device.h"
#include "core/color/srgb_tables.h"

namespace rtb {

/// Linear to an 8-bit code, as SrgbEncode8.
RTB_HD inline std::uint8_t SrgbCodeBy(const SrgbCodeTable& table,
                                      float linear) {
  using T = SrgbCodeTable;
  constexpr float kDarkest = T::kDarkest;
  // The comparison is false for NaN, which becomes black.
  const float least = linear > kDarkest ? linear : kDarkest;
  const float x = least < 1.0f ? least : 1.0f;
  const auto bits = std::bit_cast<std::uint32_t>(x);
  const std::uint32_t entry =
      table.entries[(bits >> T::kShift) - T::kFirstBucket];
  return static_cast<std::uint8_t>((entry + (bits & T::kRest)) >> T::kShift);
}

/// Linear to encoded, as SrgbEncode.
RTB_HD inline float SrgbEncodeBy(const SrgbCurveTable& table, float linear) {
  using T = SrgbCurveTable;
  const float x = linear > 0 ? (linear < 1.0f ? linear : 1.0f) : 0.0f;
  if (x <= T::kKnee) return T::kSlope * x;
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

}  // namespace rtb
