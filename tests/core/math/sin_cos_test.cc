#include "core/math/sin_cos.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/math/constants.h"

namespace rtb {
namespace {

/// Whether both are std::sin's and std::cos's; 0 may have another sign.
bool IsTheLibrarys(float angle) {
  const SineCosine both = SinCosOf(angle);
  return both.sine == std::sin(angle) && both.cosine == std::cos(angle);
}

// Angles are 2 pi times a multiple of 2^-24, as UnitFloat has them. Every 3rd:
// a polynomial that is not glibc's differs in one of some thousands.
TEST(SinCosTest, IsTheLibrarysForEveryUniform) {
  int differ = 0;
  for (std::uint32_t i = 0; i < (1u << 24); i += 3) {
    differ += !IsTheLibrarys(2 * kPi * static_cast<float>(i) * 0x1p-24f);
  }
  EXPECT_EQ(differ, 0);
}

// By their bits: small ones too, of both signs, up to 2 pi.
TEST(SinCosTest, IsTheLibrarysOfEveryMagnitudeAndSign) {
  const auto last = std::bit_cast<std::uint32_t>(2 * kPi);
  int differ = 0;
  for (std::uint32_t bits = 0; bits <= last; bits += 499) {
    differ += !IsTheLibrarys(std::bit_cast<float>(bits));
    differ += !IsTheLibrarys(-std::bit_cast<float>(bits));
  }
  EXPECT_EQ(differ, 0);
}

TEST(SinCosTest, WhatIsNoAngleGivesNoNumber) {
  for (const float none : {std::numeric_limits<float>::quiet_NaN(),
                           std::numeric_limits<float>::infinity()}) {
    EXPECT_TRUE(std::isnan(SinCosOf(none).sine));
    EXPECT_TRUE(std::isnan(SinCosOf(none).cosine));
  }
}

}  // namespace
}  // namespace rtb
