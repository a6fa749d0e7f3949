/// @file
/// The tables and constants by which single floats (srgb.cc) and vectors of
/// them (srgb-inl.h) are sRGB-encoded with the same operations in the same
/// order, and so with the same results. Not for use elsewhere.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace rtb {

/// 8-bit codes of floats by one look-up. [kDarkest, 1] falls into buckets of
/// equal leading bits, 128 an octave. A code takes up at least 1/84 of the
/// start of the octave that it lies in, so no bucket sees more than two codes.
/// With `rest` the bits below those that name the bucket, the code is
/// (entries[bucket] + rest) >> kShift: the entry holds the code at the start of
/// the bucket, and below it what makes `rest` carry from the first float of the
/// next code on.
class SrgbCodeTable {
 public:
  static constexpr float kDarkest = 0x1p-13f;  ///< Still black.
  static constexpr int kShift = 23 - 7;  ///< Leaves 7 bits of the mantissa.
  static constexpr std::uint32_t kRest = (1u << kShift) - 1;
  static constexpr std::uint32_t kFirstBucket =
      std::bit_cast<std::uint32_t>(kDarkest) >> kShift;
  static constexpr std::size_t kBuckets =
      (std::bit_cast<std::uint32_t>(1.0f) >> kShift) - kFirstBucket + 1;

  SrgbCodeTable();

  std::array<std::uint32_t, kBuckets> entries;
};

/// The one table, made at the first call.
const SrgbCodeTable& SrgbCodes();

/// Encoded values of floats in (kKnee, 1], to within 1e-7. Buckets are 16 an
/// octave; in a bucket that starts at s = 2^k m, with e = x / s - 1 in [0,
/// 1/16),
///   1.055 x^(5/12) - 0.055 = start + (start + 0.055) ((1 + e)^(5/12) - 1),
/// and the bracket is a cubic polynomial (kC1, kC2, kC3; least maximal error,
/// 5.2e-9). Two roundings of half a unit in the last place of 1 remain, that
/// of `start` and that of the last sum.
class SrgbCurveTable {
 public:
  /// The largest float that the linear piece of IEC 61966-2-1 encodes.
  static constexpr float kKnee = 0.00313079986f;
  static constexpr float kSlope = 12.92f;
  static constexpr float kOffset = 0.055f;
  static constexpr float kC1 = 0.41666498780f;
  static constexpr float kC2 = -0.12136194855f;
  static constexpr float kC3 = 0.059460949153f;
  static constexpr int kShift = 23 - 4;  ///< Leaves 4 bits of the mantissa.
  static constexpr std::uint32_t kFirstBucket =
      std::bit_cast<std::uint32_t>(0x1p-9f) >> kShift;
  static constexpr std::size_t kBuckets =
      (std::bit_cast<std::uint32_t>(1.0f) >> kShift) - kFirstBucket + 1;
  static constexpr std::size_t kBucketsAnOctave = 16;

  SrgbCurveTable();

  /// Encoded value of each bucket's first float.
  alignas(64) std::array<float, kBuckets> start;
  /// 1 / m, by the 4 leading bits of the mantissa.
  alignas(64) std::array<float, kBucketsAnOctave> reciprocal;
};

/// The one table, made at the first call.
const SrgbCurveTable& SrgbCurve();

/// IEC 61966-2-1 in double precision; `linear` in [0, 1].
double SrgbEncodeExactly(double linear);

}  // namespace rtb
