/// @file
/// The least error of 8-bit colors, found by trying all of them.
#pragma once

#include <span>

#include "encoders/fit/fit.h"

namespace rtb {

/// The least error of a mask over all pairs of 8-bit colors, each of the
/// 65536 pairs of every channel. Not for kOklab.
double LeastErrorOfAllCodes(const FitMask& mask, Blend blend,
                            std::span<const V3d> samples);

/// How much more a fit may cost: codes count as equal when noise of single
/// precision (kNoise per sub-pixel) could have made the difference.
double Tolerance(double error, std::size_t samples);

/// Samples of a cell in [0, 1] of the blend space, from one of these kinds.
enum class SampleKind { kRandom, kGray, kTwoColors, kNearlyFlat, kCorners };
inline constexpr SampleKind kSampleKinds[] = {
    SampleKind::kRandom, SampleKind::kGray, SampleKind::kTwoColors,
    SampleKind::kNearlyFlat, SampleKind::kCorners};
std::vector<V3d> MakeSamples(SampleKind kind, int count, std::uint64_t seed);

}  // namespace rtb
