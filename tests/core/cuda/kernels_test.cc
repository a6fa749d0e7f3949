// The bodies of the CUDA kernels, run on the CPU for every thread: they give
// what the backend bvh gives, bit for bit, and stay within their arrays.
#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <vector>

#include "tests/core/cuda/host_job.h"

namespace rtb {
namespace {

using rtb::testing::HostJob;
using rtb::testing::LaunchOnHost;
using rtb::testing::SceneAt;

struct Frame {
  std::string scene;
  std::string integrator;
  int spp = 1;
};

void PrintTo(const Frame& frame, std::ostream* out) {
  *out << frame.scene << " " << frame.integrator << " " << frame.spp;
}

class KernelsTest : public ::testing::TestWithParam<Frame> {};

RenderOptions OptionsOf(const Frame& frame) {
  RenderOptions options;
  options.integrator = frame.integrator;
  options.spp = frame.spp;
  options.time = 0.5;
  options.seed = 11;
  return options;
}

TEST_P(KernelsTest, GiveWhatBvhGives) {
  const Scene scene = SceneAt(GetParam().scene);
  const RenderOptions options = OptionsOf(GetParam());
  // 19 x 9 cells of 2 x 2: no multiple of a block.
  const SamplePlan plan = RegularPlan({19, 9}, 2, 2);
  const HostJob host(scene, plan, options);
  LaunchOnHost(host.job(), host.samples(),
               options.integrator == "path" ? RenderPath : RenderWhitted);
  const auto bvh = MakeBackend("bvh", scene).value();
  const Fragments expected = bvh->Render(plan, options).value();
  EXPECT_EQ(host.values(), expected.values);
  EXPECT_EQ(host.variances(), expected.variances);
  RayCounts sum;
  for (const RayCounts& counts : host.counts()) sum += counts;
  EXPECT_EQ(sum, bvh->ray_counts());
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, KernelsTest,
    ::testing::Values(Frame{"scenes/whitted.yaml", "whitted"},
                      Frame{"scenes/cornell.yaml", "whitted", 3},
                      Frame{"scenes/cornell.yaml", "path", 2},
                      Frame{"scenes/bump.yaml", "whitted"},
                      Frame{"tests/data/scenes/materials.yaml", "path", 4},
                      Frame{"scenes/sunset.yaml", "path"},
                      Frame{"scenes/glass.yaml", "whitted"},
                      Frame{"tests/data/scenes/moving.yaml", "whitted"}));

TEST(KernelsTest, RenderTheCellsThatAPlanLists) {
  const Scene scene = SceneAt("scenes/whitted.yaml");
  SamplePlan plan = RegularPlan({7, 5}, 1, 2);
  plan.cells = {34, 3, 3};
  plan.samples_before = {0, 2, 4};
  RenderOptions options;
  options.spp = 2;
  const HostJob host(scene, plan, options);
  LaunchOnHost(host.job(), host.samples(), RenderWhitted);
  const auto bvh = MakeBackend("bvh", scene).value();
  EXPECT_EQ(host.values(), bvh->Render(plan, options)->values);
}

TEST(KernelsTest, SumsTakeInEveryCountOnce) {
  // 1 + 2 + ... + 200 camera rays, in 64 sums: sum k has k + 1, k + 65, ...
  std::vector<RayCounts> counts(200);
  for (std::size_t i = 0; i < counts.size(); ++i) {
    counts[i].camera = i + 1;
    counts[i].shadow = 2;
  }
  std::vector<RayCounts> sums(64);
  const SumJob job{counts.data(), counts.size(), sums.data(), sums.size()};
  LaunchOnHost(job, sums.size(), SumCounts);
  EXPECT_EQ(sums[0].camera, 1u + 65 + 129 + 193);
  EXPECT_EQ(sums[63].camera, 64u + 128 + 192);
  RayCounts all;
  for (const RayCounts& sum : sums) all += sum;
  EXPECT_EQ(all.camera, 200u * 201 / 2);
  EXPECT_EQ(all.shadow, 400u);
  EXPECT_EQ(all.refraction, 0u);
}

}  // namespace
}  // namespace rtb
