#include "encoders/fit/moments.h"

#include <algorithm>

#include "core/base/check.h"

namespace rtb {

CenteredSamples Center(std::span<const V3d> samples) {
  CenteredSamples centered;
  for (const V3d& sample : samples) centered.mean += sample;
  centered.mean /= static_cast<double>(samples.size());
  centered.rest.reserve(samples.size());
  for (const V3d& sample : samples) {
    centered.rest.push_back(sample - centered.mean);
    centered.squares += centered.rest.back().length2();
  }
  return centered;
}

V3d Correlate(const FitMask& mask, const CenteredSamples& samples) {
  RTB_CHECK_EQ(mask.coverage.size(), samples.rest.size());
  V3d sum(0);
  for (std::size_t i = 0; i < mask.coverage.size(); ++i) {
    sum += mask.coverage[i] * samples.rest[i];
  }
  return sum;
}

double LeastError(const FitMask& mask, const CenteredSamples& samples,
                  const V3d& correlation) {
  if (mask.constant()) return samples.squares;
  return std::max(0.0, samples.squares - correlation.length2() / mask.variance);
}

}  // namespace rtb
