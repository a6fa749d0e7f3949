#include "core/math/frame.h"

#include <gtest/gtest.h>

#include "core/math/random.h"

namespace rtb {
namespace {

TEST(TangentsTest, RightHandedOrthonormalForAnyNormal) {
  for (std::uint32_t i = 0; i < 2000; ++i) {
    const auto component = [&](std::uint32_t axis) {
      return 2.0 * UnitFloat(RandomBits(i, 0, axis, 1)) - 1;
    };
    const V3d n = V3d(component(0), component(1), component(2)).normalized();
    const Tangents<double> frame = TangentsOf(n);
    EXPECT_LT((frame.s.cross(frame.t) - n).length(), 1e-12);
    EXPECT_NEAR(frame.s.length(), 1, 1e-12);
    EXPECT_NEAR(frame.s.dot(n), 0, 1e-12);
  }
}

TEST(TangentsTest, ThePolesAreExact) {
  // Duff et al. 2017: n = -z is where the older construction breaks down.
  for (const double z : {1.0, -1.0}) {
    const V3d n(0, 0, z);
    const Tangents<double> frame = TangentsOf(n);
    EXPECT_EQ(frame.s.cross(frame.t), n);
  }
}

}  // namespace
}  // namespace rtb
