#include "core/color/hsp.h"

#include <gtest/gtest.h>

namespace rtb {
namespace {

// The weights add up to 1, so a gray is as bright as its value.
TEST(HspTest, GrayIsItsValue) {
  EXPECT_DOUBLE_EQ(HspBrightness(V3d(0.25)), 0.25);
  EXPECT_EQ(HspBrightness(V3d(0)), 0);
}

// sqrt(0.299), sqrt(0.587), sqrt(0.114).
TEST(HspTest, PrimariesAreRootsOfTheirWeights) {
  EXPECT_NEAR(HspBrightness(V3d(1, 0, 0)), 0.546809, 1e-6);
  EXPECT_NEAR(HspBrightness(V3d(0, 1, 0)), 0.766159, 1e-6);
  EXPECT_NEAR(HspBrightness(V3d(0, 0, 1)), 0.337639, 1e-6);
}

}  // namespace
}  // namespace rtb
