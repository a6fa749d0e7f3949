#include "core/shading/background.h"

#include <gtest/gtest.h>

#include <utility>

#include "core/math/sobol.h"
#include "core/shading/environment_load.h"
#include "tests/core/shading/light_tools.h"

namespace rtb {
namespace {

TEST(BackgroundTest, GradientIsLinearInY) {
  const BackgroundData sky{Rgb(1, 0, 0), Rgb(0, 0, 4)};
  EXPECT_EQ(BackgroundRadiance(sky, V3f(0, -1, 0)), Rgb(1, 0, 0));
  EXPECT_EQ(BackgroundRadiance(sky, V3f(0, 1, 0)), Rgb(0, 0, 4));
  EXPECT_EQ(BackgroundRadiance(sky, V3f(1, 0, 0)), Rgb(0.5f, 0, 2));
}

// The integral of a gray gradient is 4 pi times the mean of its ends, and
// every sample says so.
TEST(BackgroundTest, GradientsAreSampledWithoutVariance) {
  for (const auto& [bottom, top] :
       {std::pair(1.0f, 1.0f), {0.2f, 3.0f}, {5.0f, 0.0f}, {0.0f, 2.0f}}) {
    const BackgroundData sky{Rgb(bottom), Rgb(top)};
    const double expected = 4 * kPiExact * (bottom + top) / 2;
    double y = 0;
    constexpr std::uint32_t kCount = 4096;
    for (std::uint32_t i = 0; i < kCount; ++i) {
      const BackgroundSample s = SampleBackground(sky, SobolOwen2(i, 2));
      ASSERT_GT(s.pdf, 0);
      EXPECT_NEAR(s.radiance.x / s.pdf, expected, 1e-4 * expected);
      EXPECT_EQ(BackgroundPdf(sky, s.direction), s.pdf);
      EXPECT_NEAR(s.direction.length(), 1, 1e-6);
      y += s.direction.y;
    }
    // Density (b + (t - b)(y + 1)/2) / (b + t): the mean of y is
    // (t - b) / (3 (t + b)).
    EXPECT_NEAR(y / kCount, (top - bottom) / (3 * (top + bottom)), 1e-3);
  }
}

TEST(BackgroundTest, DensitiesIntegrateToOne) {
  Image image(5, 4);
  for (int x = 0; x < 5; ++x) image.at(x, x % 4) = Rgb(1, 2, 3);
  const Environment environment = MakeEnvironment(std::move(image));
  for (const BackgroundData& sky :
       {BackgroundData{Rgb(0.1f, 0.5f, 2), Rgb(3, 0, 0)}, BackgroundData{},
        BackgroundData{Rgb(0), Rgb(0), ViewOf(environment)}}) {
    EXPECT_NEAR(IntegralOverSphere(
                    400, [&](const V3f& d) { return BackgroundPdf(sky, d); }),
                1, 2e-3);
  }
}

// The image stands in place of the gradient.
TEST(BackgroundTest, ImagesAreLookedUpAndSampled) {
  Image image(2, 1);
  image.at(1, 0) = Rgb(8);
  const Environment environment = MakeEnvironment(std::move(image));
  const BackgroundData sky{Rgb(1), Rgb(1), ViewOf(environment)};
  EXPECT_EQ(BackgroundRadiance(sky, V3f(1, 0, 0)), Rgb(8));
  EXPECT_EQ(BackgroundRadiance(sky, V3f(-1, 0, 0)), Rgb(0));
  const BackgroundSample s = SampleBackground(sky, V2f(0.7f, 0.5f));
  EXPECT_GT(s.direction.x, 0);
  EXPECT_EQ(s.pdf, BackgroundPdf(sky, s.direction));
}

TEST(BackgroundTest, BlackIsSampledUniformly) {
  const BackgroundSample s = SampleBackground({}, V2f(0.2f, 0.75f));
  EXPECT_FLOAT_EQ(s.pdf, static_cast<float>(1 / (4 * kPiExact)));
  EXPECT_FLOAT_EQ(s.direction.y, 0.5f);
  EXPECT_EQ(s.radiance, Rgb(0));
}

}  // namespace
}  // namespace rtb
