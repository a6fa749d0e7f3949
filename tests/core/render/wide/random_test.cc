// The sines of random-inl.h against the library's, on every instruction set.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

// This file is compiled once for each target.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/core/render/wide/random_test.cc"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/math/constants.h"
#include "core/render/wide/random-inl.h"
#include "tests/simd_targets.h"

HWY_BEFORE_NAMESPACE();
namespace rtb {
namespace HWY_NAMESPACE {

void SinesOf(const float* angles, std::size_t count, float* sines,
             float* cosines) {
  namespace hw = hwy::HWY_NAMESPACE;
  const wide::DF d;
  for (std::size_t i = 0; i < count; i += hw::Lanes(d)) {
    const wide::SinCos both = wide::SinCosOf(hw::LoadU(d, angles + i));
    hw::StoreU(both.sine, d, sines + i);
    hw::StoreU(both.cosine, d, cosines + i);
  }
}

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace rtb
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rtb {

HWY_EXPORT(SinesOf);

namespace {

// Angles are 2 pi times a multiple of 2^-24, as UnitFloat has them. Every 13th
// is enough to see a polynomial that is not glibc's: any other differs in one
// of some thousands.
TEST(WideRandomTest, SinesAreTheLibrarysOnEveryTarget) {
  constexpr std::uint32_t kStep = 13;
  std::vector<float> angles;
  for (std::uint32_t i = 0; i < (1u << 24); i += kStep) {
    angles.push_back(2 * kPi * static_cast<float>(i) * 0x1p-24f);
  }
  const std::size_t count = angles.size() / 16 * 16;
  std::vector<float> sines(count), cosines(count);
  ForEachSimdTarget([&] {
    HWY_DYNAMIC_DISPATCH(SinesOf)
    (angles.data(), count, sines.data(), cosines.data());
    int differ = 0;
    for (std::size_t i = 0; i < count; ++i) {
      differ += sines[i] != std::sin(angles[i]);
      differ += cosines[i] != std::cos(angles[i]);
    }
    EXPECT_EQ(differ, 0);
  });
}

}  // namespace
}  // namespace rtb
#endif  // HWY_ONCE
