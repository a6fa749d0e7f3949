// Statistical comparison of pictures: many cheap independent renderings
// against a converged one, as a z-test of every block of pixels (Subr and
// Arvo, "Statistical Hypothesis Testing for Assessing Monte Carlo Estimators",
// Pacific Graphics 2007), with Sidak's correction for the number of blocks.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/render/measure.h"
#include "tests/core/scene/mesh_shapes.h"

namespace rtb {
namespace {

using testing::By;
using testing::Estimate;
using testing::EstimateOf;
using testing::Runs;
using testing::SceneBuilder;

constexpr int kColumns = 24, kRows = 16, kBlock = 4;

/// Means of blocks of pixels over runs, one estimate each.
std::vector<Estimate> Blocks(const std::vector<Fragments>& runs) {
  std::vector<Estimate> blocks;
  for (int y = 0; y < kRows; y += kBlock) {
    for (int x = 0; x < kColumns; x += kBlock) {
      std::vector<double> means;
      for (const Fragments& f : runs) {
        double sum = 0;
        for (int i = 0; i < kBlock * kBlock; ++i) {
          const int pixel = (y + i / kBlock) * kColumns + x + i % kBlock;
          sum += f.values[static_cast<std::size_t>(pixel)].y;
        }
        means.push_back(sum / kBlock / kBlock);
      }
      blocks.push_back(EstimateOf(means));
    }
  }
  return blocks;
}

/// A room with all that scatters in it.
SceneBuilder Room(bool lit_by_sky) {
  SceneBuilder b;
  const Index white = b.Add(Lambertian{Rgb(0.8f)});
  const Index brass = b.Add(Metal{Rgb(0.9f, 0.7f, 0.4f), 0.4});
  const Index coat = b.Add(Plastic{Rgb(0.3f, 0.5f, 0.7f), 1.5, 0.2});
  const Index glaze = b.Add(Plastic{Rgb(0.6f, 0.3f, 0.2f), 1.5, 0});
  b.Add(Plane{V3d(0, -1, 0), V3d(0, 1, 0)}, white);
  b.Add(Plane{V3d(0, 0, -3), V3d(0, 0, 1)}, white);
  b.Add(Sphere{V3d(-1.1, -0.3, -1), 0.7}, brass);
  b.Add(Sphere{V3d(0.4, -0.4, -1.4), 0.6}, coat);
  b.Add(Box{V3d(1, -1, -1.5), V3d(1.7, 0.3, -0.8)}, glaze);
  Object& mesh = b.Add(SmoothIcosphere(2), b.Add(Mirror{Rgb(0.9f)}));
  mesh.scale = V3d(0.4);
  mesh.position = V3d(-0.2, -0.6, 0);
  if (lit_by_sky) {
    b.scene.background.kind = GradientBackground{Rgb(0.2f), Rgb(2, 3, 4)};
  }
  b.AddLight(
      QuadLight{V3d(-1, 2, -1), {V3d(1.5, 0, 0), V3d(0, 0, 1.2)}, Rgb(4), 16});
  b.AddLight(SphereLight{V3d(1.5, 1.5, 0.5), 0.3, Rgb(10), 16});
  b.AddLight(PointLight{V3d(-2, 2, 2), Rgb(4), true});
  Object& lamp = b.Add(Box{V3d(-0.2), V3d(0.2)}, b.Add(Emissive{Rgb(6)}));
  lamp.position = V3d(-1.8, 1, -2);
  b.scene.camera.vfov = 45;
  b.Look(V3d(0.2, 0.3, 4), V3d(0, 0, -1));
  return b;
}

/// The blocks of two sets of runs may differ as chance has it: no |z| over
/// Sidak's limit at 0.1 % for all blocks together, and z^2 about 1 on average.
/// The sets have `runs` and `more` members: Student's t is wider than a normal
/// by about (n - 1) / (n - 3).
void ExpectAlike(const std::vector<Estimate>& a,
                 const std::vector<Estimate>& b) {
  ASSERT_EQ(a.size(), b.size());
  double squares = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double z =
        (a[i].mean - b[i].mean) / std::hypot(a[i].error, b[i].error);
    squares += z * z;
    // 1 - 0.999^(1/24) = 4.2e-5, two-sided: 4.1 for a normal, 4.6 for t with
    // 63 degrees of freedom or so.
    EXPECT_LT(std::abs(z), 4.6) << "block " << i;
  }
  // 24 squares: the mean is 1, its standard deviation sqrt(2 / 24) = 0.29.
  EXPECT_LT(squares / static_cast<double>(a.size()), 1 + 4 * 0.29);
  EXPECT_GT(squares / static_cast<double>(a.size()), 0.2);
}

std::vector<Estimate> ByPath(const SceneBuilder& b, int depth, int spp,
                             int runs, std::uint64_t first_seed) {
  return Blocks(Runs(b, PixelPlan(kColumns, kRows), By("path", depth, spp),
                     runs, first_seed));
}

void ExpectUnbiased(const SceneBuilder& b) {
  const std::vector<Estimate> converged = ByPath(b, 4, 144, 16, 1000);
  // A single ray would take the pixels' centers alone.
  ExpectAlike(ByPath(b, 4, 2, 96, 2000), converged);
  ExpectAlike(ByPath(b, 4, 4, 64, 3000), converged);
}

TEST(ZTest, FewRaysAverageToTheConvergedPicture) {
  ExpectUnbiased(Room(false));
}

TEST(ZTest, FewRaysAverageToTheConvergedPictureUnderASky) {
  ExpectUnbiased(Room(true));
}

TEST(ZTest, WhittedsAreaLightsAverageToPathAtDepthZero) {
  SceneBuilder b = Room(false);
  // Emissive objects light others under path alone, mirrors show nothing at
  // depth 0 under either.
  b.scene.objects.pop_back();
  const SamplePlan plan = PixelPlan(kColumns, kRows);
  ExpectAlike(Blocks(Runs(b, plan, By("whitted", 0, 2), 64, 1000)),
              ByPath(b, 0, 64, 32, 2000));
}

}  // namespace
}  // namespace rtb
