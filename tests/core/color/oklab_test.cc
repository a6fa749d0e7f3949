#include "core/color/oklab.h"

#include <gtest/gtest.h>

#include "core/color/srgb.h"

namespace rtb {
namespace {

void ExpectLab(const V3d& linear, const V3d& lab) {
  const V3d found = LinearToOklab(linear);
  EXPECT_NEAR(found.x, lab.x, 1e-5);
  EXPECT_NEAR(found.y, lab.y, 1e-5);
  EXPECT_NEAR(found.z, lab.z, 1e-5);
}

// CSS Color 4 gives these for the named colors red, lime, blue and white.
TEST(OklabTest, MatchesPublishedValues) {
  ExpectLab({1, 0, 0}, {0.62796, 0.22486, 0.12585});
  ExpectLab({0, 1, 0}, {0.86644, -0.23389, 0.17950});
  ExpectLab({0, 0, 1}, {0.45201, -0.03246, -0.31153});
  ExpectLab({1, 1, 1}, {1, 0, 0});
  ExpectLab({0, 0, 0}, {0, 0, 0});
}

// A gray's L is the cube root of its linear value.
TEST(OklabTest, GrayHasNoChroma) { ExpectLab(V3d(0.125), {0.5, 0, 0}); }

TEST(OklabTest, EveryGrayAndPrimaryCodeSurvivesTheRoundTrip) {
  for (int i = 0; i < 256; ++i) {
    const auto code = static_cast<std::uint8_t>(i);
    for (const Rgb8 color : {Rgb8{code, code, code}, Rgb8{code, 0, 255},
                             Rgb8{255, code, 0}, Rgb8{0, 255, code}}) {
      const V3d linear(Decode8(color));
      EXPECT_EQ(Encode8(Rgb(OklabToLinear(LinearToOklab(linear)))), color);
    }
  }
}

}  // namespace
}  // namespace rtb
