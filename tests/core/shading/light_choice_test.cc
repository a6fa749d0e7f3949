#include "core/shading/light_choice.h"

#include <gtest/gtest.h>

#include <cmath>

namespace rtb {
namespace {

TEST(LightChoiceTest, HalfByPowerHalfAlike) {
  // Two lights, one of them dark, three emissive triangles, the background:
  // powers 6, 0, 1, 1, 2, 10 of 20; three shares, of which the triangles have
  // one together, by power.
  const double powers[] = {6, 0, 1, 1, 2, 10};
  const std::vector<double> weights = ChoiceWeights(powers, 2);
  const double expected[] = {6.0 / 20 + 1.0 / 3,  0,
                             1.0 / 20 + 1.0 / 12, 1.0 / 20 + 1.0 / 12,
                             2.0 / 20 + 1.0 / 6,  10.0 / 20 + 1.0 / 3};
  ASSERT_EQ(weights.size(), 6u);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_DOUBLE_EQ(weights[i], expected[i]) << i;
  }
}

TEST(LightChoiceTest, DarkScenesHaveNoWeights) {
  const double powers[] = {0, 0, 0};
  EXPECT_EQ(ChoiceWeights(powers, 1), std::vector<double>(3, 0));
}

TEST(LightChoiceTest, ExtremePowersStayFinite) {
  const double powers[] = {1e-300, 1e300, 1e-310, 5e299};
  for (const double weight : ChoiceWeights(powers, 2)) {
    EXPECT_TRUE(std::isfinite(weight));
    EXPECT_GE(weight, 0.25);
  }
}

}  // namespace
}  // namespace rtb
