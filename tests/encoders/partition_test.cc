#include "encoders/partition.h"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <vector>

#include "core/math/random.h"

namespace rtb {
namespace {

using Wide = std::int64_t;

/// What the split takes off the squared error - the error of the whole less
/// that of the two sides - is numerator / (n denominator).
struct Gain {
  Wide numerator;
  Wide denominator;
};

Gain GainOf(std::span<const StepColor> samples, SampleMask on) {
  const Wide n = static_cast<Wide>(samples.size());
  const Wide n1 = std::popcount(on);
  const Wide n2 = n - n1;
  Wide sums = 0;  // n n1 n2 (sum1^2 / n1 + sum2^2 / n2 - sum^2 / n)
  for (unsigned channel = 0; channel < 3; ++channel) {
    Wide sum1 = 0;
    Wide sum2 = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      ((on >> i & 1) != 0 ? sum1 : sum2) += samples[i][channel];
    }
    const Wide sum = sum1 + sum2;
    sums += n * n2 * sum1 * sum1 + n * n1 * sum2 * sum2 - n1 * n2 * sum * sum;
  }
  return {sums, n1 * n2};
}

/// The first mask without the last sample whose gain no other exceeds.
SampleMask BestByDefinition(std::span<const StepColor> samples) {
  SampleMask best = 0;
  Gain most{0, 1};
  for (SampleMask on = 1; on < SampleMask{1} << (samples.size() - 1); ++on) {
    const Gain gain = GainOf(samples, on);
    if (gain.numerator * most.denominator > most.numerator * gain.denominator) {
      best = on;
      most = gain;
    }
  }
  return best;
}

/// A component of `levels` even levels up to `most` steps.
std::int32_t Level(std::uint32_t bits, int levels, int most) {
  return static_cast<std::int32_t>(bits % static_cast<unsigned>(levels)) *
         (most / (levels - 1));
}

// Few levels make many ties, the extremes the largest numbers.
TEST(PartitionTest, ExactOneIsTheFirstOfLeastError) {
  for (const int levels : {2, 3, 4, 5, 1000}) {
    for (const int most : {4, 8192, kWhiteSteps}) {
      if (most < levels - 1) continue;
      for (std::uint32_t i = 0; i < 300; ++i) {
        const std::size_t count = i % 3 == 0 ? 4 : i % 3 == 1 ? 6 : 8;
        std::vector<StepColor> samples;
        for (std::uint32_t k = 0; k < count; ++k) {
          samples.emplace_back(Level(RandomBits(i, k, 0, 1), levels, most),
                               Level(RandomBits(i, k, 1, 1), levels, most),
                               Level(RandomBits(i, k, 2, 1), levels, most));
        }
        ASSERT_EQ(BestPartition(std::span<const StepColor>(samples)),
                  BestByDefinition(samples))
            << levels << " levels up to " << most;
      }
    }
  }
}

}  // namespace
}  // namespace rtb
