// Trees of one primitive, of coincident ones, of degenerate ones, and the most
// uneven: each is found or is not there, and the walk ends.
#include <gtest/gtest.h>

#include <cmath>

#include "core/accel/bvh_accel.h"
#include "tests/core/scene/mesh_shapes.h"

namespace rtb {
namespace {

FlatSphere SphereAt(const V3d& center, double radius, int object) {
  return {PositionRotateScale(center, V3d(0), V3d(radius, radius, radius)),
          object};
}

TEST(BvhShapesTest, OnePrimitiveOfEachKindIsATreeOfItsOwn) {
  std::vector<TriangleMesh> meshes{Icosphere(0)};
  std::vector<FlatScene> scenes(4);
  for (FlatScene& flat : scenes) flat.objects.resize(1);
  scenes[0].spheres = {SphereAt(V3d(0, 0, -5), 1, 0)};
  scenes[1].disks = {
      {PositionRotateScale(V3d(0, 0, -4), V3d(0), V3d(1, 1, 1)), 0}};
  scenes[2].triangles = {{{V3f(-9, -9, -4), V3f(9, -9, -4), V3f(0, 9, -4)}, 0}};
  scenes[3].objects[0].object_to_world.origin = V3d(0, 0, -5);
  scenes[3].meshes = {{0, 0}};
  Ray ahead, aside;
  ahead.origin = aside.origin = V3f(0.01f, 0.02f, 0);
  aside.direction = V3f(1, 0, 0);
  for (const FlatScene& flat : scenes) {
    Geometry geometry = MakeGeometry(flat, meshes);
    const BvhAccel accel = BvhAccel::Build(geometry, {Rgb(0)}).value();
    // The icosphere's facets lie inside the unit sphere.
    EXPECT_NEAR(accel.Closest(ahead).t, 4, 0.21f);
    EXPECT_TRUE(accel.Occluded(ahead));
    EXPECT_EQ(accel.Transmittance(ahead), Rgb(0));
    EXPECT_EQ(accel.Closest(aside).kind, PrimitiveKind::kNothing);
    EXPECT_FALSE(accel.Occluded(aside));
  }
}

TEST(BvhShapesTest, TenThousandCoincidentPrimitivesAreOneSurface) {
  FlatScene flat;
  flat.objects.resize(1);
  for (int i = 0; i < 10000; ++i) {
    flat.triangles.push_back(
        {{V3f(-1, -1, -7), V3f(1, -1, -7), V3f(0, 1, -7)}, 0});
    flat.spheres.push_back(SphereAt(V3d(5, 0, -7), 1, 0));
  }
  Geometry geometry = MakeGeometry(flat);
  const BvhAccel accel = BvhAccel::Build(geometry, {Rgb(0.5f)}).value();
  Ray ray;
  EXPECT_FLOAT_EQ(accel.Closest(ray).t, 7);
  ray.origin = V3f(5, 0, 0);
  EXPECT_FLOAT_EQ(accel.Closest(ray).t, 6);
  EXPECT_TRUE(accel.Occluded(ray));
  ray.origin = V3f(9, 0, 0);
  EXPECT_EQ(accel.Closest(ray).kind, PrimitiveKind::kNothing);
}

/// Spheres whose sizes and distances double from one to the next: the most
/// uneven tree that single precision has room for.
TEST(BvhShapesTest, UnevenScenesKeepTheDepthBound) {
  FlatScene flat;
  flat.objects.resize(1);
  for (int i = -40; i < 40; ++i) {
    for (int k = 0; k < 30; ++k) {
      const double d = std::ldexp(1 + k / 30.0, i);
      flat.spheres.push_back(SphereAt(V3d(0, 0, -d), d / 100, 0));
    }
  }
  Geometry geometry = MakeGeometry(flat);
  const BvhAccel accel = BvhAccel::Build(geometry, {Rgb(0)}).value();
  for (int i = -40; i < 40; ++i) {
    const float d = std::ldexp(1.0f, i);
    Ray ray;
    ray.origin = V3f(d, 0, -d);
    ray.direction = V3f(-1, 0, 0);
    EXPECT_NEAR(accel.Closest(ray).t / d, 0.99f, 1e-4f) << i;
  }
}

TEST(BvhShapesTest, DegenerateTrianglesAreNeverMet) {
  FlatScene flat;
  flat.objects.resize(1);
  const V3f a(0, 0, -5), b(1, 1, -5);
  flat.triangles = {{{a, a, a}, 0}, {{a, b, b}, 0}, {{a, (a + b) / 2, b}, 0}};
  Geometry geometry = MakeGeometry(flat);
  const BvhAccel accel = BvhAccel::Build(geometry, {Rgb(0)}).value();
  for (const V3f& target : {a, b, (a + b) / 2.0f, V3f(0.25f, 0.25f, -5)}) {
    Ray ray;
    ray.direction = target.normalized();
    EXPECT_EQ(accel.Closest(ray).kind, PrimitiveKind::kNothing);
    EXPECT_FALSE(accel.Occluded(ray));
  }
}

}  // namespace
}  // namespace rtb
