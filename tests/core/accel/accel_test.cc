// What every accelerator must answer.
#include <gtest/gtest.h>

#include <cmath>

#include "core/accel/surface.h"
#include "core/math/random.h"
#include "tests/core/accel/accels.h"
#include "tests/core/accel/random_directions.h"

namespace rtb {
namespace {

FlatSphere SphereAt(const V3d& center, double radius, int object) {
  return {PositionRotateScale(center, V3d(0), V3d(radius, radius, radius)),
          object};
}

FlatTriangle TriangleOf(const V3f& a, const V3f& b, const V3f& c, int object) {
  return {{a, b, c}, object};
}

template <class Accel>
class AccelTest : public ::testing::Test {};
TYPED_TEST_SUITE(AccelTest, testing::Accels, testing::AccelNames);

/// An accelerator together with the geometry it needs.
template <class Accel>
struct Traced {
  Traced(const FlatScene& flat, std::vector<Rgb> transmittance)
      : geometry(MakeGeometry(flat)),
        accel(Accel::Build(geometry, std::move(transmittance)).value()) {}
  Geometry geometry;
  Accel accel;
};

FlatScene SceneOfAll() {
  // Along -z: a sphere at 5 (front at 4), a disk at 8, a triangle at 10, a
  // plane at 12; each its own object.
  FlatScene flat;
  flat.objects.resize(4);
  flat.spheres = {SphereAt(V3d(0, 0, -5), 1, 0)};
  flat.disks = {{PositionRotateScale(V3d(0, 0, -8), V3d(0), V3d(3, 3, 3)), 1}};
  flat.triangles = {
      TriangleOf(V3f(-9, -9, -10), V3f(9, -9, -10), V3f(0, 9, -10), 2)};
  flat.planes = {{V3d(0, 0, -12), V3d(0, 0, 1), 3}};
  return flat;
}

V3f Away() { return V3f(0, 0, -1); }

TYPED_TEST(AccelTest, FindsTheClosestOfEveryKind) {
  const Traced<TypeParam> traced(SceneOfAll(), std::vector<Rgb>(4, Rgb(0)));
  const struct {
    float start;
    PrimitiveKind kind;
    float t;
  } cases[] = {{0, PrimitiveKind::kSphere, 4},
               {-7, PrimitiveKind::kDisk, 1},
               {-9, PrimitiveKind::kTriangle, 1},
               {-11, PrimitiveKind::kPlane, 1},
               {-13, PrimitiveKind::kNothing, 0}};
  for (const auto& c : cases) {
    Ray ray;
    ray.origin = V3f(0, 0, c.start);
    ray.direction = Away();
    const Hit hit = traced.accel.Closest(ray);
    EXPECT_EQ(hit.kind, c.kind) << c.start;
    if (c.kind != PrimitiveKind::kNothing) {
      EXPECT_FLOAT_EQ(hit.t, c.t);
    }
  }
}

TYPED_TEST(AccelTest, SurfaceOfEveryKindFacesTheViewerHere) {
  const Traced<TypeParam> traced(SceneOfAll(), std::vector<Rgb>(4, Rgb(0)));
  const float starts[] = {0, -7, -9, -11};
  for (int object = 0; object < 4; ++object) {
    Ray ray;
    ray.origin = V3f(0, 0, starts[object]);
    ray.direction = Away();
    const SurfacePoint point =
        SurfaceAt(traced.accel.geometry(), ray, traced.accel.Closest(ray));
    EXPECT_EQ(point.object, object);
    EXPECT_LT((point.normal - V3f(0, 0, 1)).length(), 1e-6f) << object;
    EXPECT_LT(std::abs(point.position.x) + std::abs(point.position.y), 1e-6f);
  }
}

TYPED_TEST(AccelTest, OpaqueSurfacesBlockWithinTheDistanceOnly) {
  const Traced<TypeParam> traced(SceneOfAll(), std::vector<Rgb>(4, Rgb(0)));
  Ray ray;
  ray.direction = Away();
  ray.t_max = 3.9f;
  EXPECT_EQ(traced.accel.Transmittance(ray), Rgb(1));
  ray.t_max = 4.1f;
  EXPECT_EQ(traced.accel.Transmittance(ray), Rgb(0));
}

TYPED_TEST(AccelTest, TintMultipliesAtEachCrossing) {
  // Two crossings of the sphere (1/2 each), one of the disk (1/4), one of the
  // triangle (1/8); the plane lies beyond.
  const Traced<TypeParam> traced(SceneOfAll(),
                                 {Rgb(0.5f), Rgb(0.25f), Rgb(0.125f), Rgb(0)});
  Ray ray;
  ray.direction = Away();
  ray.t_max = 11;
  EXPECT_EQ(traced.accel.Transmittance(ray), Rgb(0.25f * 0.25f * 0.125f));
  ray.t_max = 5;  // ends inside the sphere
  EXPECT_EQ(traced.accel.Transmittance(ray), Rgb(0.5f));
  ray.t_max = 20;
  EXPECT_EQ(traced.accel.Transmittance(ray), Rgb(0));
}

/// Six spheres, of which one lets light through, and two disks.
FlatScene FewQuadrics() {
  FlatScene flat;
  flat.objects.resize(9);
  for (int i = 0; i < 6; ++i) {
    flat.spheres.push_back(
        SphereAt(V3d(2 * i - 5, i % 3 - 1, i % 2), 0.7 + 0.1 * i, i));
  }
  flat.disks = {
      {PositionRotateScale(V3d(0, -2, 0), V3d(90, 0, 0), V3d(6, 6, 6)), 6},
      {PositionRotateScale(V3d(1, 0, -2), V3d(20, 30, 0), V3d(2, 2, 2)), 7}};
  return flat;
}

// Eight quadrics are tested one by one; a triangle far away brings a tree.
TYPED_TEST(AccelTest, FewQuadricsAnswerAsATreeOfThem) {
  FlatScene flat = FewQuadrics();
  std::vector<Rgb> transmittance(9, Rgb(0));
  transmittance[2] = Rgb(0.5f);
  const Traced<TypeParam> few(flat, transmittance);
  flat.triangles = {
      TriangleOf(V3f(0, 1e4f, 0), V3f(1, 1e4f, 0), V3f(0, 1e4f, 1), 8)};
  const Traced<TypeParam> tree(flat, transmittance);
  int hits = 0, dim = 0;
  for (std::uint32_t i = 0; i < 4000; ++i) {
    Ray ray;
    ray.origin = testing::RandomDirection(i, 1) * 4;
    ray.direction = testing::RandomDirection(i, 2);
    const Hit hit = few.accel.Closest(ray), same = tree.accel.Closest(ray);
    ASSERT_EQ(hit.kind, same.kind) << i;
    ASSERT_EQ(hit.primitive, same.primitive) << i;
    ASSERT_EQ(hit.t, same.t) << i;
    ray.t_max = 6;
    const Rgb through = few.accel.Transmittance(ray);
    ASSERT_EQ(through, tree.accel.Transmittance(ray)) << i;
    ASSERT_EQ(few.accel.Occluded(ray), tree.accel.Occluded(ray)) << i;
    hits += hit.kind != PrimitiveKind::kNothing;
    dim += through != Rgb(0) && through != Rgb(1);
  }
  EXPECT_GT(hits, 400);
  EXPECT_GT(dim, 20);
}

TYPED_TEST(AccelTest, EmptySceneIsNothing) {
  const Traced<TypeParam> traced(FlatScene{}, {});
  EXPECT_EQ(traced.accel.Closest(Ray{}).kind, PrimitiveKind::kNothing);
  EXPECT_EQ(traced.accel.Transmittance(Ray{}), Rgb(1));
}

V3f RandomDirection(std::uint32_t i) { return testing::RandomDirection(i, 3); }

/// Rays that leave a convex body outwards must never meet it again, at any
/// scale and offset: a self-intersection would.
TYPED_TEST(AccelTest, NoSelfIntersectionAtAnyScale) {
  for (const double scale : {1e-3, 1.0, 1e3, 1e6}) {
    for (const double offset : {0.0, 1000.0}) {
      FlatScene flat;
      flat.objects.resize(1);
      flat.spheres = {SphereAt(V3d(offset * scale, 0, 0), scale, 0)};
      const Traced<TypeParam> traced(flat, {Rgb(0)});
      int again = 0, hits = 0;
      for (std::uint32_t i = 0; i < 20000; ++i) {
        const V3f outward = RandomDirection(i);
        Ray in;
        in.origin = V3f(static_cast<float>(offset * scale), 0, 0) +
                    outward * static_cast<float>(3 * scale);
        in.direction =
            (-outward + RandomDirection(i + 50000) * 0.2f).normalized();
        const Hit hit = traced.accel.Closest(in);
        if (hit.kind == PrimitiveKind::kNothing) continue;
        ++hits;
        const SurfacePoint p = SurfaceAt(traced.accel.geometry(), in, hit);
        // Any direction of the outer hemisphere, grazing ones included.
        V3f away = RandomDirection(i + 90000);
        if (away.dot(p.normal) < 0) away = -away;
        Ray out;
        out.direction = away;
        out.origin = LeavingOrigin(p, away);
        if (traced.accel.Closest(out).kind != PrimitiveKind::kNothing) {
          ++again;
        }
      }
      EXPECT_GT(hits, 15000);
      EXPECT_EQ(again, 0) << "scale " << scale << " offset " << offset;
    }
  }
}

/// A parallelogram as two triangles, as quads are composed.
FlatScene Parallelogram(const V3d& corner, const V3d& e0, const V3d& e1) {
  FlatScene flat;
  flat.objects.resize(1);
  const V3f a(corner), b(corner + e0), c(corner + e0 + e1), d(corner + e1);
  flat.triangles = {TriangleOf(a, b, c, 0), TriangleOf(a, c, d, 0)};
  return flat;
}

/// How many of the rays that leave a parallelogram meet it again.
template <class Accel>
int Reintersections(const FlatScene& flat) {
  const Traced<Accel> traced(flat, {Rgb(0)});
  int again = 0;
  for (std::uint32_t i = 0; i < 20000; ++i) {
    float u = UnitFloat(RandomBits(i, 1, 0, 3));
    float v = UnitFloat(RandomBits(i, 2, 0, 3));
    if (u + v > 1) {
      u = 1 - u;
      v = 1 - v;
    }
    const Hit hit{PrimitiveKind::kTriangle, static_cast<int>(i % 2), 1, u, v};
    const SurfacePoint p = SurfaceAt(traced.accel.geometry(), Ray{}, hit);
    Ray out;
    // Half of them graze.
    out.direction = RandomDirection(i);
    if (i % 4 < 2) {
      out.direction -= p.normal * (0.999f * out.direction.dot(p.normal));
      out.direction.normalize();
    }
    out.origin = LeavingOrigin(p, out.direction);
    if (traced.accel.Transmittance(out) != Rgb(1)) ++again;
  }
  return again;
}

TYPED_TEST(AccelTest, TrianglesDoNotShadowThemselves) {
  const V3d corner(3, 1, -2), e0(-5, -0.5, 6), e1(-2, -4, 2.25);
  for (const double scale : {1e-3, 1.0, 1e3, 1e6}) {
    EXPECT_EQ(Reintersections<TypeParam>(
                  Parallelogram(corner * scale, e0 * scale, e1 * scale)),
              0)
        << scale;
  }
}

TYPED_TEST(AccelTest, FarLargeAndNarrowTrianglesDoNotShadowThemselves) {
  const V3d e0(-5, -0.5, 6), e1(-2, -4, 2.25);
  for (const V3d& corner : {V3d(1000, 0, 0), V3d(-300, 1000, 500)}) {
    EXPECT_EQ(Reintersections<TypeParam>(Parallelogram(corner, e0, e1)), 0);
  }
  EXPECT_EQ(Reintersections<TypeParam>(
                Parallelogram(V3d(-4e4, -3e4, -5e4), e0 * 2e4, e1 * 2e4)),
            0);
  EXPECT_EQ(Reintersections<TypeParam>(
                Parallelogram(V3d(1, 2, 3), e0 * 100, e0.cross(e1) * 1e-3)),
            0);
}

/// A closed mesh: rays from inside, aimed at its edges, must not escape.
TYPED_TEST(AccelTest, EdgesAreWatertight) {
  FlatScene flat;
  flat.objects.resize(1);
  // An octahedron with uneven vertices.
  const V3f v[6] = {V3f(1.1f, 0.07f, 0.01f),  V3f(-0.9f, 0.03f, -0.2f),
                    V3f(0.02f, 1.3f, 0.1f),   V3f(-0.1f, -1.2f, 0.05f),
                    V3f(0.08f, -0.04f, 0.8f), V3f(0.1f, 0.06f, -1.4f)};
  for (const int z : {4, 5}) {
    const int ring[4] = {0, 2, 1, 3};
    for (int k = 0; k < 4; ++k) {
      flat.triangles.push_back(
          TriangleOf(v[ring[k]], v[ring[(k + 1) % 4]], v[z], 0));
    }
  }
  const Traced<TypeParam> traced(flat, {Rgb(0)});
  int leaks = 0;
  for (std::uint32_t i = 0; i < 200000; ++i) {
    const FlatTriangle& t = flat.triangles[i % flat.triangles.size()];
    const auto edge = (i / 8) % 3;
    const float s = UnitFloat(RandomBits(i, 3, 0, 4));
    const V3f target =
        t.vertices[edge] * (1 - s) + t.vertices[(edge + 1) % 3] * s;
    Ray ray;
    ray.origin = RandomDirection(i) * 0.3f;
    ray.direction = (target - ray.origin).normalized();
    if (traced.accel.Closest(ray).kind == PrimitiveKind::kNothing) ++leaks;
  }
  EXPECT_EQ(leaks, 0);
}

}  // namespace
}  // namespace rtb
