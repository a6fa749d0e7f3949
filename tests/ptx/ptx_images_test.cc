// The kernels as nvcc compiles them: their PTX, translated to C++, renders what
// the backend bvh renders.
#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <vector>

#include "tests/core/cuda/host_job.h"
#include "tests/core/render/scenes.h"
#include "tests/ptx/ptx_launch.h"

extern "C" {
void ptx_rtb_render_whitted(unsigned char* job);
void ptx_rtb_render_path(unsigned char* job);
void ptx_rtb_sum_counts(unsigned char* job);
}

namespace rtb {
namespace {

using rtb::testing::HostJob;
using rtb::testing::LaunchPtx;
using rtb::testing::SceneAt;
using rtb::testing::SceneBuilder;

/// Nothing differs where + - * / and square roots do all; a last bit of atan2,
/// which is the device's own, changes the weights of area lights by less.
constexpr float kExact = 1e-6f;
/// Where atan2 chooses texels of a map: 4 of 800 samples are off by more than
/// 1e-6, at most by 4.3e-6.
constexpr float kTexels = 1e-5f;

/// Samples that differ by more than `tolerance`.
int CountDifferent(const std::vector<Rgb>& a, const std::vector<Rgb>& b,
                   float tolerance) {
  int different = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    different += !(MaxAbs(a[i] - b[i]) <= tolerance);
  }
  return different;
}

/// A mesh placed twice, turned and stretched, over a checkered floor.
Scene InstancedScene() {
  SceneBuilder b;
  TriangleMesh mesh;
  mesh.positions = {V3f(0, 1, 0), V3f(1, -1, 1), V3f(-1, -1, 1),
                    V3f(0, -1, -1)};
  mesh.normals = mesh.positions;
  for (V3f& normal : mesh.normals) normal.normalize();
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  const Index red = b.Add(Plastic{Rgb(0.7f, 0.2f, 0.1f), 1.5, 0.2});
  const Index floor = b.Add(Lambertian{Rgb(0.5f)}, CheckerTexture{});
  Object& first = b.Add(mesh, red);
  first.position = V3d(-1.2, 0, -5);
  first.rotate = V3d(0, 30, 10);
  Object second = first;
  second.position = V3d(1.2, 0, -5);
  second.scale = V3d(0.5, 1.3, 1);
  b.scene.objects.push_back(second);
  b.Add(Plane{V3d(0, -1.5, 0), V3d(0, 1, 0)}, floor);
  b.AddLight(PointLight{V3d(2, 4, 0), Rgb(40), true});
  b.SetBackground(Rgb(0.2f, 0.3f, 0.5f));
  return b.scene;
}

struct Frame {
  std::string name;
  Scene scene;
  std::string integrator;
  int spp = 1;
  float tolerance = kExact;
};

void PrintTo(const Frame& frame, std::ostream* out) { *out << frame.name; }

class PtxImagesTest : public ::testing::TestWithParam<Frame> {};

TEST_P(PtxImagesTest, AreThoseOfBvh) {
  const Frame& frame = GetParam();
  RenderOptions options;
  options.integrator = frame.integrator;
  options.spp = frame.spp;
  const SamplePlan plan = RegularPlan({20, 10}, 2, 2);
  const HostJob host(frame.scene, plan, options);
  LaunchPtx(
      frame.integrator == "path" ? ptx_rtb_render_path : ptx_rtb_render_whitted,
      host.job(), host.samples());
  const auto bvh = MakeBackend("bvh", frame.scene).value();
  const Fragments expected = bvh->Render(plan, options).value();
  EXPECT_EQ(CountDifferent(host.values(), expected.values, frame.tolerance), 0);
  RayCounts counts;
  for (const RayCounts& one : host.counts()) counts += one;
  EXPECT_EQ(counts.camera, bvh->ray_counts().camera);
  EXPECT_GT(counts.shadow, 0u);
}

INSTANTIATE_TEST_SUITE_P(
    Frames, PtxImagesTest,
    ::testing::Values(
        Frame{"whitted", SceneAt("scenes/whitted.yaml"), "whitted"},
        Frame{"whitted_paths", SceneAt("scenes/whitted.yaml"), "path", 2},
        Frame{"cornell", SceneAt("scenes/cornell.yaml"), "whitted", 2},
        Frame{"cornell_paths", SceneAt("scenes/cornell.yaml"), "path", 2},
        Frame{"area_light_paths", SceneAt("scenes/cornell-area.yaml"), "path",
              2},
        Frame{"instances", InstancedScene(), "whitted"},
        Frame{"instances_paths", InstancedScene(), "path"},
        Frame{"textures_and_lights", SceneAt("scenes/bump.yaml"), "whitted", 1,
              kTexels},
        Frame{"materials", SceneAt("tests/data/scenes/materials.yaml"),
              "whitted"},
        Frame{"materials_paths", SceneAt("tests/data/scenes/materials.yaml"),
              "path"},
        Frame{"sky_paths", SceneAt("scenes/sunset.yaml"), "path"},
        Frame{"glass", SceneAt("scenes/glass.yaml"), "whitted"},
        Frame{"metal_paths", SceneAt("scenes/metal.yaml"), "path"},
        Frame{"phong", SceneAt("scenes/gallery.yaml"), "whitted"},
        Frame{"moving", SceneAt("tests/data/scenes/moving.yaml"), "whitted"}),
    [](const auto& frame) { return frame.param.name; });

TEST(PtxKernelsTest, SumCounts) {
  std::vector<RayCounts> counts(200);
  for (std::size_t i = 0; i < counts.size(); ++i) counts[i].camera = i + 1;
  std::vector<RayCounts> sums(70);
  LaunchPtx(ptx_rtb_sum_counts,
            SumJob{counts.data(), counts.size(), sums.data(), sums.size()},
            sums.size());
  RayCounts all;
  for (const RayCounts& sum : sums) all += sum;
  EXPECT_EQ(all.camera, 200u * 201 / 2);
  EXPECT_EQ(sums[69].camera, 70u + 140);
}

}  // namespace
}  // namespace rtb
