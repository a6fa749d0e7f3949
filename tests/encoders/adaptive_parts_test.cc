#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/math/random.h"
#include "encoders/adaptive/choose_rays.h"
#include "encoders/adaptive/rebuild.h"
#include "encoders/adaptive/reliance.h"

namespace rtb {
namespace {

constexpr GridSize kGrid{4, 3};
constexpr double kCellAspect = 0.5;

float Random(int i, int dimension) {
  return UnitFloat(RandomBits(static_cast<std::uint32_t>(i), 0,
                              static_cast<std::uint32_t>(dimension), 17));
}

/// `each` samples in every cell, at random places, in random grays.
SeenSamples RandomSamples(int each) {
  SamplePlan plan;
  plan.grid = kGrid;
  plan.samples_per_cell = each;
  const int count = kGrid.cells() * each;
  Fragments fragments;
  for (int i = 0; i < count; ++i) {
    plan.positions.emplace_back(Random(i, 0), Random(i, 1));
    fragments.values.emplace_back(Random(i, 2));
  }
  SeenSamples samples(kGrid);
  samples.Add(plan, fragments);
  return samples;
}

/// In sixteenths of a cell's height, from the grid's top left.
V2f PlaceOf(int cell, const V2f& position) {
  const V2f corner(static_cast<float>(cell % kGrid.columns),
                   static_cast<float>(cell / kGrid.columns));
  return (corner + position) * V2f(8, 16);
}

VoronoiMap MapOf(const SeenSamples& samples) {
  VoronoiMap map(kGrid, kCellAspect, Priority::kSquare);
  map.Clear();
  map.Insert(samples.all(), 1);
  return map;
}

// What many rays a cell would gain, chosen one at a time in every cell, holds
// the wanted ones: no shorter way may choose others.
TEST(AdaptiveChooseRays, ChoosesTheLargestGains) {
  const SeenSamples samples = RandomSamples(2);
  const VoronoiMap map = MapOf(samples);
  RayRequest request;
  request.most_per_cell = 12;
  request.rays = kGrid.cells() * request.most_per_cell;
  std::vector<float> all;
  for (const RayChoice& ray : RayChooser(map, samples).Choose(request)) {
    all.push_back(ray.gain);
  }
  ASSERT_EQ(all.size(), static_cast<std::size_t>(request.rays));
  std::ranges::sort(all, std::greater<>());
  for (const int rays : {1, 5, 12, 13, 40, 100}) {
    request.rays = rays;
    std::vector<float> gains;
    for (const RayChoice& ray : RayChooser(map, samples).Choose(request)) {
      gains.push_back(ray.gain);
    }
    std::ranges::sort(gains, std::greater<>());
    EXPECT_TRUE(std::ranges::equal(
        gains, std::span(all).first(static_cast<std::size_t>(rays))))
        << rays;
  }
}

TEST(AdaptiveChooseRays, SortsByCell) {
  const SeenSamples samples = RandomSamples(2);
  RayRequest request;
  request.rays = 30;
  const VoronoiMap map = MapOf(samples);
  const auto rays = RayChooser(map, samples).Choose(request);
  EXPECT_EQ(rays.size(), 30u);
  EXPECT_TRUE(std::ranges::is_sorted(rays, {}, &RayChoice::cell));
}

// Where a sample lies in the middle of a sub-pixel, its weight is 1 / 0.25^2,
// that of one n sub-pixels away 1 / (n^2 + 0.25)^2: the sub-pixel is its color
// but for the second and third nearest, at least 2 away each, at most
// 2 * 0.0554 / 16 = 0.7 % together.
TEST(AdaptiveRebuild, ShowsSamplesWhereTheyAre) {
  SamplePlan plan;
  plan.grid = kGrid;
  plan.samples_per_cell = 4;
  plan.positions = {V2f(0.5f / 8, 0.5f / 16), V2f(4.5f / 8, 4.5f / 16),
                    V2f(1.5f / 8, 9.5f / 16), V2f(6.5f / 8, 13.5f / 16)};
  Fragments fragments;
  for (int i = 0; i < kGrid.cells() * 4; ++i) {
    fragments.values.emplace_back(Random(i, 3), Random(i, 4), Random(i, 5));
  }
  SeenSamples samples(kGrid);
  samples.Add(plan, fragments);
  const RebuiltRaster raster =
      Rebuild(samples, 8, 16, kCellAspect, Texture::kKept, 1);
  for (int cell = 0; cell < kGrid.cells(); ++cell) {
    for (std::size_t i = 0; i < 4; ++i) {
      const V2f at = plan.positions[i] * V2f(8, 16);
      const int pixel = static_cast<int>(at.y) * 8 + static_cast<int>(at.x);
      const Rgb shown = raster.cell(cell)[static_cast<std::size_t>(pixel)];
      const SeenSample& sample =
          samples.all()[static_cast<std::size_t>(cell) * 4 + i];
      EXPECT_TRUE(shown.equalWithAbsError(sample.encoded, 0.008f))
          << shown << sample.encoded;
    }
  }
}

TEST(AdaptiveRebuild, NeverLeavesTheRangeOfTheSamples) {
  const SeenSamples samples = RandomSamples(5);
  for (const Texture texture : {Texture::kExpected, Texture::kKept}) {
    const RebuiltRaster raster =
        Rebuild(samples, 3, 7, kCellAspect, texture, 2);
    ASSERT_EQ(raster.encoded.size(), static_cast<std::size_t>(12 * 3 * 7));
    for (const Rgb& color : raster.encoded) {
      EXPECT_GE(color.x, 0.0f);
      EXPECT_LE(color.x, 1.0f);
    }
  }
}

/// Variance of the red of a noise's raster.
double SpreadOfNoise(Texture texture) {
  const SeenSamples samples = RandomSamples(16);
  const RebuiltRaster raster = Rebuild(samples, 8, 16, kCellAspect, texture, 1);
  double sum = 0, squares = 0;
  for (const Rgb& color : raster.encoded) {
    const auto red = static_cast<double>(color.x);
    sum += red;
    squares += red * red;
  }
  const auto count = static_cast<double>(raster.encoded.size());
  return squares / count - sum * sum / (count * count);
}

// In noise nothing but the mean is to be expected. Of 16 samples a cell some 60
// count in a wide mean: were all else equal, 1/20 of the spread of means of 3.
TEST(AdaptiveRebuild, SmoothsNoiseWhereTheMeanIsAskedFor) {
  EXPECT_LT(SpreadOfNoise(Texture::kExpected),
            SpreadOfNoise(Texture::kKept) / 3);
}

/// `each` samples in every cell, at random places, of a gray that depends on
/// the place in cells.
template <class GrayAt>
SeenSamples SamplesOf(int each, const GrayAt& gray_at) {
  SamplePlan plan;
  plan.grid = kGrid;
  plan.samples_per_cell = each;
  Fragments fragments;
  for (int i = 0; i < kGrid.cells() * each; ++i) {
    plan.positions.emplace_back(Random(i, 0), Random(i, 1));
    fragments.values.emplace_back(
        gray_at(PlaceOf(i / each, plan.positions.back())));
  }
  SeenSamples samples(kGrid);
  samples.Add(plan, fragments);
  return samples;
}

std::vector<float> ReliancesOf(const SeenSamples& samples) {
  return Reliances(ByCell(samples, kCellAspect), 1);
}

/// Mean squared error of a rebuilt gray.
template <class GrayAt>
double ErrorOf(const GrayAt& gray_at) {
  const RebuiltRaster raster =
      Rebuild(SamplesOf(8, gray_at), 8, 16, kCellAspect, Texture::kKept, 1);
  double sum = 0;
  for (int cell = 0; cell < kGrid.cells(); ++cell) {
    for (int i = 0; i < 128; ++i) {
      const V2f pixel(static_cast<float>(i % 8), static_cast<float>(i / 8));
      const float gray =
          gray_at(PlaceOf(cell, (pixel + V2f(0.5f)) / V2f(8, 16)));
      const Rgb& color = raster.cell(cell)[static_cast<std::size_t>(i)];
      sum += std::pow(static_cast<double>(color.x - gray), 2);
    }
  }
  return sum / (128 * kGrid.cells());
}

// Along edges samples count as nearer, unless these run both ways.
TEST(AdaptiveRebuild, FollowsEdges) {
  const auto band = [](float at, float width) {
    return static_cast<int>(at / width) % 2;
  };
  const double stripes = ErrorOf(
      [&](const V2f& place) { return band(place.y, 6) == 0 ? 0.1f : 0.8f; });
  const double checkers = ErrorOf([&](const V2f& place) {
    return band(place.y, 12) == band(place.x, 12) ? 0.1f : 0.8f;
  });
  EXPECT_LT(stripes, 0.8 * checkers);
}

// A gradient is foretold by what is near, wherever one looks.
TEST(AdaptiveReliance, IsFullOnAGradient) {
  const auto gray = [](const V2f& place) { return place.x / 32; };
  for (const float reliance : ReliancesOf(SamplesOf(8, gray))) {
    EXPECT_GT(reliance, 0.9f);
  }
}

// So is a half plane, but for the samples beside the edge: a slope of 1/3,
// which stands for 1 - (2/3)^4 = 0.8, takes an error in one sample of six.
TEST(AdaptiveReliance, IsHighAtAnEdge) {
  const auto gray = [](const V2f& place) {
    return place.x + place.y / 3 < 20 ? 0.1f : 0.8f;
  };
  for (const float reliance : ReliancesOf(SamplesOf(16, gray))) {
    EXPECT_GT(reliance, 0.8f);
  }
}

// Independent samples do not foretell one another: a slope of 0, up to 1.5
// standard deviations of about 1 / sqrt(3 x 3 x 16 / 2).
TEST(AdaptiveReliance, IsLowInNoise) {
  float sum = 0;
  const std::vector<float> reliances = ReliancesOf(RandomSamples(16));
  for (const float reliance : reliances) sum += reliance;
  EXPECT_LT(sum / static_cast<float>(reliances.size()), 0.4f);
}

TEST(AdaptiveReliance, IsFullWithoutEvidence) {
  const auto white = [](const V2f&) { return 1.0f; };
  for (const float reliance : ReliancesOf(SamplesOf(4, white))) {
    EXPECT_EQ(reliance, 1.0f);
  }
  SeenSamples one(GridSize{1, 1});
  SamplePlan plan;
  plan.grid = {1, 1};
  plan.samples_per_cell = 1;
  plan.positions = {V2f(0.5f, 0.5f)};
  one.Add(plan, Fragments(plan));
  EXPECT_EQ(Reliances(ByCell(one, kCellAspect), 1), std::vector<float>{1.0f});
}

}  // namespace
}  // namespace rtb
