// The backend cuda gives the images that bvh gives, on a GPU.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "core/render/cuda_backend.h"
#include "core/scene/load.h"
#include "tests/core/render/difference.h"
#include "tests/gpu/gpu_scenes.h"

namespace rtb {
namespace {

using rtb::testing::CanonicalScene;
using rtb::testing::CanonicalScenes;
using rtb::testing::Difference;

/// Skips, saying why, where no GPU can be used.
class GpuTest : public ::testing::Test {
 protected:
  void SetUp() override {
    const Status runs = CudaRuns();
    if (!runs) GTEST_SKIP() << runs.error().ToString();
  }
};

class GpuSceneTest : public GpuTest,
                     public ::testing::WithParamInterface<std::string> {};

/// @param share of pixels that may be off by more than 1e-3.
void ExpectAlike(const Fragments& expected, const Fragments& got,
                 double share) {
  ASSERT_EQ(expected.values.size(), got.values.size());
  const Difference difference(expected.values, got.values);
  EXPECT_LE(difference.median, 1e-6);
  EXPECT_LE(difference.off, share * static_cast<double>(got.values.size()));
  EXPECT_LT(difference.rmse, 1e-4);
}

TEST_P(GpuSceneTest, GivesTheImagesOfBvh) {
  const Scene scene = LoadScene(CanonicalScene(GetParam())).value();
  const auto bvh = MakeBackend("bvh", scene).value();
  const auto cuda = MakeBackend("cuda", scene).value();
  EXPECT_EQ(cuda->name(), "cuda");
  const SamplePlan plan = PixelPlan(240, 160);
  // The second time moves what moves; the third is the first again.
  for (const double time : {0.0, 0.7, 0.0}) {
    RenderOptions options;
    options.time = time;
    const Fragments expected = bvh->Render(plan, options).value();
    const auto got = cuda->Render(plan, options);
    ASSERT_TRUE(got.has_value()) << got.error().ToString();
    ExpectAlike(expected, *got, 0.0005);
    const double rays = static_cast<double>(bvh->ray_counts().total());
    EXPECT_NEAR(static_cast<double>(cuda->ray_counts().total()) / rays, 1,
                1e-3);
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, GpuSceneTest,
                         ::testing::ValuesIn(CanonicalScenes()),
                         [](const auto& test) {
                           std::string name = test.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST_F(GpuTest, GivesThePathsOfBvh) {
  for (const std::string name : {"cornell", "glass", "sunset"}) {
    const Scene scene = LoadScene(CanonicalScene(name)).value();
    RenderOptions options;
    options.integrator = "path";
    options.spp = 3;
    const SamplePlan plan = PixelPlan(120, 80);
    const Fragments expected =
        MakeBackend("bvh", scene).value()->Render(plan, options).value();
    const Fragments got =
        MakeBackend("cuda", scene).value()->Render(plan, options).value();
    // Last bits of sin and cos send some paths elsewhere.
    ExpectAlike(expected, got, 0.005);
    EXPECT_EQ(got.variances.size(), got.values.size());
  }
}

TEST_F(GpuTest, FramesUnderWayDoNotDisturbEachOther) {
  const Scene scene = LoadScene(CanonicalScene("moving")).value();
  const auto cuda = MakeCudaBackend(scene).value();
  const SamplePlan small = PixelPlan(60, 40);
  const SamplePlan large = PixelPlan(240, 160);
  RenderOptions early, late;
  late.time = 0.9;
  const Fragments first = cuda->Render(small, early).value();
  const Fragments second = cuda->Render(large, late).value();
  ASSERT_TRUE(cuda->Submit(small, early).has_value());
  ASSERT_TRUE(cuda->Submit(large, late).has_value());
  EXPECT_EQ(cuda->Collect()->values, first.values);
  ASSERT_TRUE(cuda->Submit(small, early).has_value());
  EXPECT_EQ(cuda->Collect()->values, second.values);
  EXPECT_EQ(cuda->Collect()->values, first.values);
}

TEST_F(GpuTest, MemoryThatDoesNotSufficeIsAnErrorThatSaysSo) {
  const Scene scene = LoadScene(CanonicalScene("cornell")).value();
  const auto cuda = MakeBackend("cuda", scene).value();
  // 2^32 samples of 12 and 48 bytes: 240 GiB.
  const SamplePlan plan = RegularPlan({1 << 15, 1 << 14}, 2, 4);
  const auto refused = cuda->Render(plan, {});
  if (refused) GTEST_SKIP() << "this GPU has the memory";
  EXPECT_EQ(refused.error().kind, ErrorKind::kFailure);
  EXPECT_NE(refused.error().what.find("memory"), std::string::npos);
  // The backend goes on working.
  EXPECT_TRUE(cuda->Render(PixelPlan(8, 8), {}).has_value());
}

}  // namespace
}  // namespace rtb
