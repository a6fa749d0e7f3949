#include "encoders/fit/moments.h"

#include <algorithm>

#include "core/base/check.h"

namespace rtb {

namespace {

/// The sum of `term(i)` for i below `count`. Four sums side by side, as each
/// addition waits for the one before.
template <class Term>
auto SumOfTerms(std::size_t count, const Term& term) {
  using Sum = decltype(term(std::size_t{0}));
  Sum sums[4] = {Sum(0), Sum(0), Sum(0), Sum(0)};
  std::size_t i = 0;
  for (; i + 4 <= count; i += 4) {
    for (std::size_t k = 0; k < 4; ++k) sums[k] += term(i + k);
  }
  for (; i < count; ++i) sums[0] += term(i);
  return Sum(sums[0] + sums[1] + sums[2] + sums[3]);
}

}  // namespace

CenteredSamples Center(std::span<const V3d> samples) {
  CenteredSamples centered;
  const std::size_t count = samples.size();
  centered.mean = SumOfTerms(count, [&](std::size_t i) { return samples[i]; }) /
                  static_cast<double>(count);
  centered.rest.reserve(count);
  for (const V3d& sample : samples) {
    centered.rest.push_back(sample - centered.mean);
  }
  centered.squares = SumOfTerms(
      count, [&](std::size_t i) { return centered.rest[i].length2(); });
  return centered;
}

V3d Correlate(const FitMask& mask, const CenteredSamples& samples) {
  RTB_CHECK_EQ(mask.coverage.size(), samples.rest.size());
  return SumOfTerms(mask.coverage.size(), [&](std::size_t i) {
    return mask.coverage[i] * samples.rest[i];
  });
}

double LeastError(const FitMask& mask, const CenteredSamples& samples,
                  const V3d& correlation) {
  if (mask.constant()) return samples.squares;
  return std::max(0.0, samples.squares - correlation.length2() / mask.variance);
}

}  // namespace rtb
