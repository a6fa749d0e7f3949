// The flat BVH gives the images that Embree gives.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "core/render/backend.h"
#include "core/scene/load.h"
#include "tests/core/render/difference.h"
#include "tests/scene_files.h"

namespace rtb {
namespace {

using rtb::testing::Difference;

const std::filesystem::path kScenes =
    std::filesystem::path(RTB_TEST_SOURCE_DIR) / "scenes";

class BvhBackendTest : public ::testing::TestWithParam<std::string> {};

TEST_P(BvhBackendTest, GivesEmbreesImage) {
  const auto scene = LoadScene(kScenes / (GetParam() + ".yaml"));
  ASSERT_TRUE(scene.has_value());
  auto embree = MakeBackend("embree", *scene).value();
  auto bvh = MakeBackend("bvh", *scene).value();
  EXPECT_EQ(bvh->name(), "bvh");
  const SamplePlan plan = PixelPlan(96, 64);
  for (const double time : {0.0, 0.7}) {
    RenderOptions options;
    options.time = time;
    const Fragments expected = embree->Render(plan, options).value();
    const Fragments got = bvh->Render(plan, options).value();
    const Difference difference(expected.values, got.values);
    EXPECT_LE(difference.median, 1e-6);
    EXPECT_LE(difference.off, 3);  // 0.05 % of 6144 pixels
    EXPECT_LT(difference.rmse, 1e-4);
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, BvhBackendTest,
                         ::testing::ValuesIn(testing::SceneNames(kScenes)),
                         [](const auto& test) {
                           std::string name = test.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

// Random numbers are counter-based: paths go the same way while rounding does
// not send them elsewhere.
TEST(BvhPathTest, GivesEmbreesPaths) {
  for (const std::string name : {"cornell", "glass", "whitted"}) {
    const auto scene = LoadScene(kScenes / (name + ".yaml"));
    ASSERT_TRUE(scene.has_value());
    RenderOptions options;
    options.integrator = "path";
    const SamplePlan plan = PixelPlan(96, 64);
    const Fragments expected =
        MakeBackend("embree", *scene).value()->Render(plan, options).value();
    const Fragments got =
        MakeBackend("bvh", *scene).value()->Render(plan, options).value();
    const Difference difference(expected.values, got.values);
    EXPECT_LE(difference.median, 1e-6) << name;
    EXPECT_LE(difference.off, 6) << name;  // 0.1 %
    EXPECT_LT(difference.rmse, 1e-4) << name;
  }
}

}  // namespace
}  // namespace rtb
