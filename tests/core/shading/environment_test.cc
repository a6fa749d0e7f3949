#include "core/shading/environment.h"

#include <gtest/gtest.h>

#include <limits>
#include <utility>

#include "core/color/luminance.h"
#include "core/math/sobol.h"
#include "core/shading/environment_load.h"
#include "tests/core/image/image_files.h"
#include "tests/core/shading/light_tools.h"
#include "tests/temp_folder.h"

namespace rtb {
namespace {

/// Gray noise between 0 and 1, squared twice so that it varies much.
Environment Noise(int width, int height) {
  Image image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const float u = UnitFloat(RandomBits(
          static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y), 0, 1));
      image.at(x, y) = Rgb(u * u * u * u);
    }
  }
  return MakeEnvironment(std::move(image));
}

/// Mean and spread over `count` samples of radiance / pdf.
struct Estimate {
  double mean, deviation;
};
Estimate EstimateOf(const EnvironmentData& view, std::uint32_t count) {
  double sum = 0, squares = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    const BackgroundSample s = SampleEnvironment(view, SobolOwen2(i, 3));
    const double value = s.radiance.x / s.pdf;
    sum += value;
    squares += value * value;
  }
  const double mean = sum / count;
  return {mean, std::sqrt(std::max(0.0, squares / count - mean * mean))};
}

double Integral(const EnvironmentData& view) {
  return IntegralOverSphere(
      800, [&](const V3f& d) { return EnvironmentRadiance(view, d).x; });
}

void ExpectPosition(const V3f& direction, const V2f& expected) {
  const Environment environment = MakeEnvironment(Image(8, 4));
  const V2f p = EnvironmentPosition(ViewOf(environment), direction);
  EXPECT_LT((p - expected).length(), 1e-5f) << direction << " " << p;
}

// 8 columns over 360 degrees, 4 rows over 180: -z in the middle, +x to the
// right of it, +y at the top.
TEST(EnvironmentTest, Orientation) {
  ExpectPosition(V3f(0, 0, -1), V2f(4, 2));
  ExpectPosition(V3f(1, 0, 0), V2f(6, 2));
  ExpectPosition(V3f(-1, 0, 0), V2f(2, 2));
  ExpectPosition(V3f(1, 0, -1).normalized(), V2f(5, 2));
  ExpectPosition(V3f(0, 1, -1).normalized(), V2f(4, 1));
  ExpectPosition(V3f(0, -1, -1).normalized(), V2f(4, 3));
  const Environment environment = MakeEnvironment(Image(8, 4));
  EXPECT_EQ(EnvironmentPosition(ViewOf(environment), V3f(0, 1, 0)).y, 0);
  EXPECT_NEAR(EnvironmentPosition(ViewOf(environment), V3f(0, -1, 0)).y, 4,
              1e-6);
}

TEST(EnvironmentTest, WrapsAroundAndClampsAtThePoles) {
  Image image(4, 2);
  for (int x = 0; x < 4; ++x) {
    image.at(x, 0) = Rgb(static_cast<float>(x + 1));
    image.at(x, 1) = Rgb(10);
  }
  const Environment environment = MakeEnvironment(std::move(image));
  const EnvironmentData view = ViewOf(environment);
  // +z is the seam: on the upper row the mean of columns 0 and 3, (1 + 4) / 2;
  // at 45 degrees up the row's center is reached.
  EXPECT_NEAR(EnvironmentRadiance(view, V3f(0, 1, 1).normalized()).x, 2.5,
              1e-5);
  // Above the row's center it goes on unchanged, whatever the other pole has.
  EXPECT_NEAR(EnvironmentRadiance(view, V3f(0, 4, -1).normalized()).x, 2.5,
              1e-5);
  EXPECT_NEAR(EnvironmentRadiance(view, V3f(0, -4, -1).normalized()).x, 10,
              1e-5);
}

TEST(EnvironmentTest, SampledIntegralIsTheQuadratures) {
  for (const auto& [width, height] : {std::pair(16, 8), {7, 5}, {1, 1}}) {
    const Environment environment = Noise(width, height);
    const EnvironmentData view = ViewOf(environment);
    const double expected = Integral(view);
    const Estimate estimate = EstimateOf(view, 1 << 15);
    EXPECT_NEAR(estimate.mean, expected, 2e-3 * expected) << width;
    // Uniform directions would spread by more than the mean itself.
    EXPECT_LT(estimate.deviation, 0.6 * estimate.mean) << width;
  }
}

TEST(EnvironmentTest, ConstantRadianceHasNoVariance) {
  Image image(6, 3);
  for (Rgb& texel : image.pixels()) texel = Rgb(2);
  const Environment environment = MakeEnvironment(std::move(image));
  for (std::uint32_t i = 0; i < 1000; ++i) {
    const BackgroundSample s =
        SampleEnvironment(ViewOf(environment), SobolOwen2(i, 0));
    EXPECT_NEAR(s.pdf, 1 / (4 * kPiExact), 1e-6);
    EXPECT_NEAR(s.direction.length(), 1, 1e-6);
  }
}

// A sun of one texel in 64 x 32, in the middle and at a pole: from 256 samples
// its light is known to a few percent; uniform ones would mostly miss it.
TEST(EnvironmentTest, OneBrightTexelIsFound) {
  for (const int row : {0, 13, 31}) {
    Image image(64, 32);
    image.at(21, row) = Rgb(1e5f);
    const Environment environment = MakeEnvironment(std::move(image));
    const EnvironmentData view = ViewOf(environment);
    const double expected = Integral(view);
    const Estimate estimate = EstimateOf(view, 256);
    EXPECT_NEAR(estimate.mean, expected, 0.05 * expected) << row;
  }
}

TEST(EnvironmentTest, DensityAgreesWithTheSamples) {
  const Environment environment = Noise(32, 16);
  const EnvironmentData view = ViewOf(environment);
  int different = 0;
  for (std::uint32_t i = 0; i < 10000; ++i) {
    const BackgroundSample s = SampleEnvironment(view, SobolOwen2(i, 1));
    EXPECT_EQ(s.radiance, EnvironmentRadiance(view, s.direction));
    // On the border of a texel rounding may tell the neighbor's.
    if (EnvironmentPdf(view, s.direction) != s.pdf) ++different;
  }
  EXPECT_LE(different, 5);
}

TEST(EnvironmentTest, DensityIntegratesToOne) {
  const Environment environment = Noise(32, 16);
  const EnvironmentData view = ViewOf(environment);
  EXPECT_NEAR(IntegralOverSphere(
                  800, [&](const V3f& d) { return EnvironmentPdf(view, d); }),
              1, 2e-3);
  double solid_angle = 0;
  for (int row = 0; row < 16; ++row) {
    solid_angle += 32 * TexelSolidAngle(32, 16, row);
  }
  EXPECT_NEAR(solid_angle, 4 * kPiExact, 1e-5);
}

// Samples of a row fill its band evenly in y, the mean of which is the mean of
// the cosines at its borders.
TEST(EnvironmentTest, RowsAreSampledEvenlyAlsoAtThePoles) {
  constexpr int kHeight = 2048;
  for (const int row : {0, 1, 700, 1023, 1024, 2046, 2047}) {
    const double a = kPiExact * row / kHeight;
    const double b = kPiExact * (row + 1) / kHeight;
    double sum = 0;
    for (int i = 0; i < 1000; ++i) {
      const float fraction = (static_cast<float>(i) + 0.5f) / 1000;
      const V3f d = DirectionInRow(row, kHeight, fraction, 1.0f);
      const double angle = std::atan2(std::hypot(d.x, d.z), d.y);
      EXPECT_GE(angle, a - 1e-6);
      EXPECT_LE(angle, b + 1e-6);
      sum += 1 - std::cos(angle);
    }
    const double expected = 1 - (std::cos(a) + std::cos(b)) / 2;
    EXPECT_NEAR(sum / 1000, expected, 1e-4 * expected + 1e-7) << row;
  }
}

TEST(EnvironmentTest, BlackImagesAreSampledWithoutHarm) {
  const Environment environment = MakeEnvironment(Image(4, 2));
  const BackgroundSample s =
      SampleEnvironment(ViewOf(environment), V2f(0.3f, 0.9f));
  EXPECT_GT(s.pdf, 0);
  EXPECT_EQ(s.radiance, Rgb(0));
}

TEST(LoadEnvironmentTest, ReadsLinearRadiance) {
  const TempFolder folder;
  Write(folder / "sky.exr", Named(2, 1, {"R", "G", "B"}),
        {100, 2, 3, 0.5f, 0, 0});
  const auto environment = LoadEnvironment(folder / "sky.exr");
  ASSERT_TRUE(environment) << environment.error().ToString();
  EXPECT_EQ(environment->image.at(0, 0), Rgb(100, 2, 3));
  // The middle of the left half looks along -x.
  EXPECT_EQ(EnvironmentRadiance(ViewOf(*environment), V3f(-1, 0, 0)),
            Rgb(100, 2, 3));
}

TEST(LoadEnvironmentTest, ErrorsNameTheFile) {
  const TempFolder folder;
  const auto file = folder / "sky.exr";
  const auto missing = LoadEnvironment(file);
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().place, file.string());
  for (const float bad : {-1.0f, std::numeric_limits<float>::infinity(),
                          std::numeric_limits<float>::quiet_NaN()}) {
    Write(file, Named(2, 1, {"R", "G", "B"}), {1, 1, 1, 1, bad, 1});
    const auto broken = LoadEnvironment(file);
    ASSERT_FALSE(broken);
    EXPECT_EQ(broken.error().kind, ErrorKind::kBadInput);
    EXPECT_EQ(broken.error().place, file.string());
    EXPECT_NE(broken.error().what.find("column 1, row 0"), std::string::npos);
  }
}

}  // namespace
}  // namespace rtb
