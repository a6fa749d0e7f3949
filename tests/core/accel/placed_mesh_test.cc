#include <gtest/gtest.h>

#include <cmath>

#include "core/accel/surface.h"
#include "core/accel/surface_uv.h"
#include "tests/core/accel/accels.h"
#include "tests/core/accel/random_directions.h"

namespace rtb {
namespace {

constexpr std::uint64_t kSeed = 11;

float Uniform(std::uint32_t i, std::uint32_t dimension) {
  return testing::Uniform(i, dimension, kSeed);
}

V3f RandomDirection(std::uint32_t i) {
  return testing::RandomDirection(i, kSeed);
}

/// A closed octahedron with uneven vertices, outward triangles.
TriangleMesh Gem() {
  TriangleMesh mesh;
  mesh.positions = {V3f(1.1f, 0.07f, 0.01f),  V3f(-0.9f, 0.03f, -0.2f),
                    V3f(0.02f, 1.3f, 0.1f),   V3f(-0.1f, -1.2f, 0.05f),
                    V3f(0.08f, -0.04f, 0.8f), V3f(0.1f, 0.06f, -1.4f)};
  const std::array<int, 4> ring = {0, 2, 1, 3};
  for (std::size_t k = 0; k < 4; ++k) {
    mesh.triangles.push_back({ring[k], ring[(k + 1) % 4], 4});
    mesh.triangles.push_back({ring[(k + 1) % 4], ring[k], 5});
  }
  return mesh;
}

template <class Accel>
class PlacedMeshTest : public ::testing::Test {};
TYPED_TEST_SUITE(PlacedMeshTest, testing::Accels, testing::AccelNames);

/// Uses of one mesh, the last `moving` of which move.
template <class Accel>
struct Traced {
  Traced(TriangleMesh mesh, const std::vector<Affined>& places,
         std::size_t moving, Rgb first_transmittance = Rgb(0))
      : meshes{std::move(mesh)},
        geometry(MakeGeometry(Uses(places, 0, places.size() - moving), meshes)),
        accel(Build(places, places.size() - moving, first_transmittance)) {}

  static FlatScene Uses(const std::vector<Affined>& places, std::size_t begin,
                        std::size_t end) {
    FlatScene flat;
    for (std::size_t i = begin; i < end; ++i) {
      flat.meshes.push_back({0, static_cast<Index>(flat.objects.size())});
      flat.objects.push_back({kNone, places[i]});
    }
    return flat;
  }

  Accel Build(const std::vector<Affined>& places, std::size_t still,
              const Rgb& first) {
    ReplaceMoving(Uses(places, still, places.size()), &geometry);
    std::vector<Rgb> transmittance(places.size(), Rgb(0));
    transmittance[0] = first;
    return Accel::Build(geometry, transmittance).value();
  }

  std::vector<TriangleMesh> meshes;
  Geometry geometry;
  Accel accel;
};

std::vector<Affined> Places() {
  return {PositionRotateScale(V3d(-4, 1, 2), V3d(20, -40, 75), V3d(2, 0.5, 1)),
          PositionRotateScale(V3d(3, -2, 0), V3d(0, 10, 0), V3d(1, 1, 3))};
}

/// The same triangles as one mesh in the world.
TriangleMesh Flattened(const TriangleMesh& mesh,
                       const std::vector<Affined>& places) {
  TriangleMesh all;
  for (const Affined& place : places) {
    const auto first = static_cast<int>(all.positions.size());
    for (const V3f& p : mesh.positions) {
      all.positions.push_back(V3f(place.Point(V3d(p))));
    }
    for (const auto& [a, b, c] : mesh.triangles) {
      all.triangles.push_back({first + a, first + b, first + c});
    }
  }
  return all;
}

/// A ray from a far sphere through the middle of the places.
Ray TestRay(std::uint32_t i) {
  Ray ray;
  ray.origin = RandomDirection(i) * 12.0f;
  const V3f target = RandomDirection(i + 70000) * 5.0f;
  ray.direction = (target - ray.origin).normalized();
  return ray;
}

struct Agreement {
  int hits = 0;
  int differing = 0;  ///< One hits, the other does not: edges.
  float worst_point = 0;
  float worst_normal = 0;
};

template <class Accel>
Agreement Compare(const Accel& a, const Accel& b) {
  Agreement result;
  for (std::uint32_t i = 0; i < 20000; ++i) {
    const Ray ray = TestRay(i);
    const Hit ha = a.Closest(ray), hb = b.Closest(ray);
    const bool hit = ha.kind != PrimitiveKind::kNothing;
    if (hit != (hb.kind != PrimitiveKind::kNothing)) ++result.differing;
    if (!hit || hb.kind == PrimitiveKind::kNothing) continue;
    const SurfacePoint pa = SurfaceAt(a.geometry(), ray, ha);
    const SurfacePoint pb = SurfaceAt(b.geometry(), ray, hb);
    ++result.hits;
    result.worst_point =
        std::max(result.worst_point, (pa.position - pb.position).length());
    // Next to an edge either neighbor may be met.
    if (ha.primitive % 8 != hb.primitive % 8) continue;
    result.worst_normal =
        std::max(result.worst_normal, (pa.normal - pb.normal).length());
  }
  return result;
}

TYPED_TEST(PlacedMeshTest, EqualsItsTrianglesInTheWorld) {
  const Traced<TypeParam> placed(Gem(), Places(), 0);
  const Traced<TypeParam> flat(Flattened(Gem(), Places()), {Affined{}}, 0);
  const Agreement a = Compare(placed.accel, flat.accel);
  EXPECT_GT(a.hits, 1500);
  EXPECT_LE(a.differing, 2);
  EXPECT_LT(a.worst_point, 1e-4f);
  EXPECT_LT(a.worst_normal, 1e-5f);
}

TYPED_TEST(PlacedMeshTest, MovedEqualsBuiltThere) {
  std::vector<Affined> places = Places();
  Traced<TypeParam> moved(Gem(), places, 1);
  places[1] = PositionRotateScale(V3d(0, 3, -1), V3d(5, 5, 5), V3d(1, 2, 1));
  ReplaceMoving(Traced<TypeParam>::Uses(places, 1, 2), &moved.geometry);
  ASSERT_TRUE(moved.accel.Update(std::vector<Rgb>(2, Rgb(0))).has_value());
  const Traced<TypeParam> built(Gem(), places, 1);
  const Agreement a = Compare(moved.accel, built.accel);
  EXPECT_GT(a.hits, 1000);
  EXPECT_EQ(a.differing, 0);
  EXPECT_EQ(a.worst_point, 0);
  const Traced<TypeParam> before(Gem(), Places(), 1);
  EXPECT_GT(Compare(moved.accel, before.accel).differing, 100);
}

/// From any point of a placed convex mesh, a ray that leaves it outwards must
/// not meet it again, at any scale and offset.
TYPED_TEST(PlacedMeshTest, NoSelfIntersectionAtAnyScale) {
  TriangleMesh gem = Gem();
  for (const double scale : {1e-3, 1.0, 1e3, 1e6}) {
    for (const double offset : {0.0, 1000.0}) {
      const Affined place =
          PositionRotateScale(V3d(offset, -offset / 3, 0) * scale,
                              V3d(30, 50, 70), V3d(scale, scale, 2 * scale));
      const Traced<TypeParam> traced(gem, {place}, 0);
      int again = 0;
      for (std::uint32_t i = 0; i < 20000; ++i) {
        Hit hit{PrimitiveKind::kMesh, static_cast<int>(i % 8), 1, 0, 0, 0};
        hit.u = Uniform(i, 5);
        hit.v = Uniform(i, 6) * (1 - hit.u);
        const SurfacePoint p = SurfaceAt(traced.accel.geometry(), Ray{}, hit);
        Ray out;
        out.direction = RandomDirection(i);
        if (out.direction.dot(p.normal) < 0) out.direction *= -1;
        out.origin = LeavingOrigin(p, out.direction);
        if (traced.accel.Transmittance(out) != Rgb(1)) ++again;
      }
      EXPECT_EQ(again, 0) << "scale " << scale << " offset " << offset;
    }
  }
}

TYPED_TEST(PlacedMeshTest, TransparentUsesLetLightThrough) {
  const Traced<TypeParam> traced(
      Gem(),
      {Affined{}, PositionRotateScale(V3d(0, 0, -5), V3d(0), V3d(1, 1, 1))}, 1,
      Rgb(0.5f));
  Ray ray;
  ray.origin = V3f(0.01f, 0.02f, 10);
  // In and out of the first, whose transmittance is 1/2; the second is opaque.
  EXPECT_EQ(traced.accel.Transmittance(ray), Rgb(0));
  ray.t_max = 12.5f;
  EXPECT_EQ(traced.accel.Transmittance(ray), Rgb(0.25f));
}

TYPED_TEST(PlacedMeshTest, SmoothNormalsGoByTheInverseTranspose) {
  // One triangle in z = 0 whose vertex normals all lean along (1, 0, 1):
  // under scale (2, 1, 1) the world normal is (1/2, 0, 1), normalized.
  TriangleMesh mesh;
  mesh.positions = {V3f(0, 0, 0), V3f(1, 0, 0), V3f(0, 1, 0)};
  mesh.normals.assign(3, V3f(1, 0, 1).normalized());
  mesh.triangles = {{0, 1, 2}};
  const Traced<TypeParam> traced(
      mesh, {PositionRotateScale(V3d(0), V3d(0), V3d(2, 1, 1))}, 0);
  const Hit hit{PrimitiveKind::kMesh, 0, 1, 0.25f, 0.25f, 0};
  const SurfacePoint p = SurfaceAt(traced.accel.geometry(), Ray{}, hit);
  EXPECT_EQ(p.normal, V3f(0, 0, 1));
  EXPECT_LT((p.shading_normal - V3f(0.5f, 0, 1).normalized()).length(), 1e-6f);
  EXPECT_LT((p.position - V3f(0.5f, 0.25f, 0)).length(), 1e-6f);
}

TYPED_TEST(PlacedMeshTest, TextureCoordinatesRunWithTheSurface) {
  // u = 2x + 1, v = x + 3y on the mesh, which is then scaled by 2 in x:
  // in the world dp/du (v fixed): x' = 2x, y: solve -> (1, -1/3 * 1/2, 0).
  TriangleMesh mesh;
  mesh.positions = {V3f(0, 0, 0), V3f(1, 0, 0), V3f(0, 1, 0)};
  mesh.uvs = {V2f(1, 0), V2f(3, 1), V2f(1, 3)};
  mesh.triangles = {{0, 1, 2}};
  const Traced<TypeParam> traced(
      mesh, {PositionRotateScale(V3d(0), V3d(0), V3d(2, 1, 1))}, 0);
  const Hit hit{PrimitiveKind::kMesh, 0, 1, 0.5f, 0.25f, 0};
  const GeometryView& g = traced.accel.geometry();
  const SurfaceUv uv = UvAt(g, hit, SurfaceAt(g, Ray{}, hit));
  EXPECT_LT((uv.uv - V2f(2, 1.25f)).length(), 1e-6f);
  EXPECT_LT((uv.dp_du - V3f(1, -1.0f / 6, 0)).length(), 1e-6f);
  EXPECT_LT((uv.dp_dv - V3f(0, 1.0f / 3, 0)).length(), 1e-6f);
}

}  // namespace
}  // namespace rtb
