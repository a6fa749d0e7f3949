// A frame of a moving scene equals a still scene written with everything where
// it is then.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/render/measure.h"
#include "tests/core/scene/mesh_shapes.h"

namespace rtb {
namespace {

using testing::By;
using testing::CountOff;
using testing::SceneBuilder;

using Interpolation = Path::Interpolation;

/// The test's own view of a path of four points, at equal times.
struct Track {
  Interpolation interpolation;
  bool loop;
  std::vector<V3d> points = {V3d(0), V3d(0.8, 0, 0.3), V3d(0.5, 0.6, -0.2),
                             V3d(-0.4, 0.2, 0.5)};
  double duration = 3;

  Path ToPath() const {
    Path path{"p", points, {}, duration, loop, interpolation};
    // Four segments in the time when it returns to the first point, else 3.
    const double step = duration / (loop ? 4 : 3);
    for (int i = 0; i < 4; ++i) path.times.push_back(i * step);
    return path;
  }

  V3d At(double time) const {
    const double place = loop ? std::fmod(time / duration * 4, 4)
                              : std::min(time / duration * 3, 3.0);
    const int i = static_cast<int>(place);
    const double u = place - i;
    const auto point = [&](int k) {
      const int wrapped = loop ? (k + 4) % 4 : std::clamp(k, 0, 3);
      return points[static_cast<std::size_t>(wrapped)];
    };
    if (interpolation == Interpolation::kLinear) {
      return point(i) * (1 - u) + point(i + 1) * u;
    }
    // Hermite's form with the tangents (next - previous) / 2.
    const V3d p = point(i), q = point(i + 1);
    const V3d dp = (q - point(i - 1)) * 0.5, dq = (point(i + 2) - p) * 0.5;
    const double u2 = u * u, u3 = u2 * u;
    return p * (2 * u3 - 3 * u2 + 1) + dp * (u3 - 2 * u2 + u) +
           q * (3 * u2 - 2 * u3) + dq * (u3 - u2);
  }
};

const Track kTracks[] = {{Interpolation::kLinear, false},
                         {Interpolation::kCatmullRom, false},
                         {Interpolation::kLinear, true},
                         {Interpolation::kCatmullRom, true}};
constexpr double kTimes[] = {0.3, 1.7, 3.9};

enum class Mover {
  kObject,
  kMesh,
  kGroup,
  kChild,
  kInstance,
  kPoint,
  kSpot,
  kQuadLight,
  kSphereLight,
  kCamera
};
constexpr Mover kMovers[] = {
    Mover::kObject,      Mover::kMesh,  Mover::kGroup, Mover::kChild,
    Mover::kInstance,    Mover::kPoint, Mover::kSpot,  Mover::kQuadLight,
    Mover::kSphereLight, Mover::kCamera};

/// Sends an owner's position along a path, or writes the offset into it.
struct Sender {
  bool moving;
  V3d offset;
  void operator()(bool mine, V3d* position, Index* path) const {
    if (!mine) return;
    if (moving) {
      *path = 0;
    } else {
      *position += offset;
    }
  }
};

/// A ball, a mesh and its instance, a group of two.
SceneBuilder WithObjects(Mover mover, const Sender& send) {
  SceneBuilder b;
  const Index clay = b.Add(Lambertian{Rgb(0.7f, 0.5f, 0.3f)});
  const Index steel = b.Add(Metal{Rgb(0.8f), 0});
  const Index shine = b.Add(Emissive{Rgb(2)});
  b.Add(Plane{V3d(0, -1, 0), V3d(0, 1, 0)}, clay);
  Object& ball = b.Add(Sphere{V3d(-1.2, 0, 0), 0.6}, steel);
  send(mover == Mover::kObject, &ball.position, &ball.path);
  Object& gem = b.Add(SmoothIcosphere(1), clay);
  gem.id = "gem";
  gem.position = V3d(1.2, -0.3, 0);
  gem.scale = V3d(0.5, 0.7, 0.5);
  send(mover == Mover::kMesh, &gem.position, &gem.path);
  Object child;
  child.shape = Box{V3d(-0.3), V3d(0.3)};
  child.material = shine;
  child.position = V3d(0.2, 0.1, 0);
  send(mover == Mover::kChild, &child.position, &child.path);
  Object disk;
  disk.shape = Disk{V3d(0.5, 0.5, 0), V3d(0, 1, 1), 0.3};
  Object group;
  group.shape = Group{};
  group.material = clay;
  group.position = V3d(0, 0.4, -1);
  group.rotate = V3d(0, 40, 10);
  group.scale = V3d(1, 1.3, 0.9);
  group.children = {child, disk};
  send(mover == Mover::kGroup, &group.position, &group.path);
  b.scene.objects.push_back(group);
  Object copy;
  copy.shape = Instance{"gem"};
  copy.position = V3d(0.1, 1.2, -0.5);
  copy.scale = V3d(0.4);
  send(mover == Mover::kInstance, &copy.position, &copy.path);
  b.scene.objects.push_back(copy);
  return b;
}

/// The scene in which `mover` is sent on its way.
SceneBuilder Staged(Mover mover, const Sender& send) {
  SceneBuilder b = WithObjects(mover, send);
  PointLight point{V3d(2, 3, 2), Rgb(10), true};
  SpotLight spot{V3d(-2, 3, 2), V3d(2, -3, -2), Rgb(15), 15, 10};
  QuadLight quad{V3d(-1, 2, -2), {V3d(1, 0, 0), V3d(0, 0, 1)}, Rgb(3), 4};
  SphereLight bulb{V3d(-2, 1, 1), 0.2, Rgb(9), 4};
  Index paths[4] = {kNone, kNone, kNone, kNone};
  send(mover == Mover::kPoint, &point.position, &paths[0]);
  send(mover == Mover::kSpot, &spot.position, &paths[1]);
  send(mover == Mover::kQuadLight, &quad.corner, &paths[2]);
  send(mover == Mover::kSphereLight, &bulb.center, &paths[3]);
  b.AddLight(point);
  b.AddLight(spot);
  b.AddLight(quad);
  b.AddLight(bulb);
  for (std::size_t i = 0; i < 4; ++i) b.scene.lights[i].path = paths[i];
  b.Look(V3d(0.3, 0.8, 5), V3d(0));
  Camera& camera = b.scene.camera;
  send(mover == Mover::kCamera, &camera.position, &camera.path);
  return b;
}

TEST(MovementTest, AFrameEqualsTheSceneWrittenThere) {
  const SamplePlan plan = PixelPlan(36, 24);
  for (const Track& track : kTracks) {
    for (const Mover mover : kMovers) {
      SceneBuilder moving = Staged(mover, {true, V3d(0)});
      moving.scene.paths = {track.ToPath()};
      const auto backend = MakeBackend("embree", moving.scene).value();
      RenderOptions options = By("whitted", 2);
      const Fragments start = backend->Render(plan, options).value();
      for (const double time : kTimes) {
        const SceneBuilder still = Staged(mover, {false, track.At(time)});
        options.time = time;
        const Fragments frame = backend->Render(plan, options).value();
        const Fragments written = still.Render(plan, By("whitted", 2));
        EXPECT_LE(CountOff(frame, written, 2e-5f), 4)
            << static_cast<int>(mover) << " at " << time << " " << track.loop
            << static_cast<int>(track.interpolation);
        EXPECT_GT(CountOff(frame, start, 1e-3f), 4)
            << static_cast<int>(mover) << " at " << time;
      }
    }
  }
}

TEST(MovementTest, TheGazeMoves) {
  const Track& track = kTracks[1];
  SceneBuilder b = Staged(Mover::kChild, {false, V3d(0)});
  Camera& camera = b.scene.camera;
  camera.has_look_at = true;
  camera.look_at = V3d(0, 0.2, 0);
  SceneBuilder moving = b;
  moving.scene.paths = {track.ToPath()};
  moving.scene.camera.look_path = 0;
  for (const double time : kTimes) {
    camera.look_at = V3d(0, 0.2, 0) + track.At(time);
    RenderOptions options = By("whitted", 2);
    options.time = time;
    EXPECT_LE(CountOff(moving.Render(PixelPlan(36, 24), options),
                       b.Render(PixelPlan(36, 24), By("whitted", 2)), 2e-5f),
              4);
  }
}

// What a backend has rendered before does not show.
TEST(MovementTest, ThereAndBackIsTheSameBitForBit) {
  for (const Mover mover : kMovers) {
    SceneBuilder b = Staged(mover, {true, V3d(0)});
    b.scene.paths = {kTracks[1].ToPath()};
    for (const char* integrator : {"whitted", "path"}) {
      const auto used = MakeBackend("embree", b.scene).value();
      RenderOptions options = By(integrator, 2, 2);
      for (const double time : {0.0, 1.0, 0.0}) {
        options.time = time;
        const Fragments again =
            used->Render(PixelPlan(24, 16), options).value();
        EXPECT_EQ(again.values, b.Render(PixelPlan(24, 16), options).values)
            << static_cast<int>(mover) << " " << time;
      }
    }
  }
}

}  // namespace
}  // namespace rtb
