#include "encoders/steps.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "core/color/srgb.h"
#include "tests/encoders/testing.h"

namespace rtb {
namespace {

// A code that has been to linear light is a whole code again, also when the
// linear value is off by a few units in the last place.
TEST(StepsTest, CodesAreWhole) {
  for (int code = 0; code < 256; ++code) {
    float linear = SrgbDecode8(static_cast<std::uint8_t>(code));
    EXPECT_EQ(EncodedSteps(linear), code * kStepsPerCode) << code;
    linear = std::nextafter(linear, 1.0f);
    EXPECT_EQ(EncodedSteps(linear), code * kStepsPerCode) << code;
  }
}

// Errors of the transfer, 1e-7, are 0.21 steps, and rounding adds 0.5.
TEST(StepsTest, AreTheEncodedValueToTheNearest) {
  for (const Rgb& color : RandomValues(100'000, 11)) {
    const double encoded = SrgbEncode(color.x);
    EXPECT_NEAR(EncodedSteps(color.x), encoded * kWhiteSteps, 0.6);
    EXPECT_NEAR(FromSteps({EncodedSteps(color.x), 0, 0}).x, encoded,
                0.6 / kWhiteSteps);
  }
}

TEST(StepsTest, ClipAndTakeNanForZero) {
  EXPECT_EQ(EncodedSteps(-1), 0);
  EXPECT_EQ(EncodedSteps(std::numeric_limits<float>::quiet_NaN()), 0);
  EXPECT_EQ(EncodedSteps(7), kWhiteSteps);
  std::array<StepColor, 1> steps = {StepColor(7)};
  EncodedSteps(std::array{Rgb(-1, 7, 0)}, steps);
  EXPECT_EQ(steps[0], StepColor(0, kWhiteSteps, 0));
}

}  // namespace
}  // namespace rtb
