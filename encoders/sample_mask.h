/// @file
/// SampleMask: a set of a cell's samples; and what decides without tie-breaks
/// by noise. Host and device.
#pragma once

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "core/base/host_device.h"
#include "core/math/vec.h"

namespace rtb {

/// A set of samples: bit i stands for sample i (bit 0 = top left, row by row).
using SampleMask = std::uint32_t;

/// The mask of all of `count` samples.
RTB_HD inline SampleMask AllSamples(std::size_t count) {
  return (SampleMask{1} << count) - 1;
}

/// Differences below this (of values in 0..1) are noise of single precision,
/// such as codes pick up on their way to linear light and back; they decide
/// no tie and no rounding. It is 1/10000 of an 8-bit code.
inline constexpr double kNoise = 1e-4 / 255;

/// The number of the lowest sample of a mask that is not empty. nvcc 13.0 takes
/// std::countr_zero for the constant 32.
RTB_HD inline int LowestSample(SampleMask mask) {
  return std::popcount(~mask & (mask - 1));
}

/// The mean of the samples in a mask that is not empty.
RTB_HD inline V3d MeanUnder(const V3d* samples, std::size_t count,
                            SampleMask mask) {
  V3d sum(0);
  for (std::size_t i = 0; i < count; ++i) {
    if ((mask >> i & 1) != 0) sum += samples[i];
  }
  return sum / static_cast<double>(std::popcount(mask));
}

/// An encoded value in [0, 1] as a code, rounded half up.
RTB_HD inline std::uint8_t RoundHalfUp(double encoded) {
  const double code = std::floor((encoded + kNoise) * 255 + 0.5);
  return static_cast<std::uint8_t>(code < 0 ? 0.0
                                            : (code > 255 ? 255.0 : code));
}

}  // namespace rtb
