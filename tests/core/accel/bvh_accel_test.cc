// What the flat BVH promises beyond what every accelerator does.
#include "core/accel/bvh_accel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "core/accel/bvh_tracer.h"
#include "core/accel/embree_accel.h"
#include "tests/core/accel/random_directions.h"
#include "tests/core/scene/mesh_shapes.h"

namespace rtb {
namespace {

constexpr std::uint64_t kSeed = 31;

V3f RandomDirection(std::uint32_t i) {
  return testing::RandomDirection(i, kSeed);
}

/// Small triangles, spheres and disks all over [-10, 10]^3, one object each.
FlatScene Clutter(int of_each, std::uint32_t seed) {
  FlatScene flat;
  const auto place = [&](int i) {
    const auto k = seed + static_cast<std::uint32_t>(3 * i);
    return V3f(testing::Uniform(k, 5, kSeed), testing::Uniform(k, 6, kSeed),
               testing::Uniform(k, 7, kSeed)) *
               20.0f -
           V3f(10);
  };
  for (int i = 0; i < 3 * of_each; ++i) {
    const auto k = seed + static_cast<std::uint32_t>(i);
    const Index object = static_cast<Index>(flat.objects.size());
    flat.objects.emplace_back();
    const V3f p = place(i);
    const V3d turn(V3f(RandomDirection(k) * 180.0f));
    if (i % 3 == 0) {
      flat.triangles.push_back(
          {{p, p + RandomDirection(k), p + RandomDirection(k + 999)}, object});
    } else if (i % 3 == 1) {
      flat.spheres.push_back(
          {PositionRotateScale(V3d(p), turn, V3d(0.4, 0.7, 0.2)), object});
    } else {
      flat.disks.push_back(
          {PositionRotateScale(V3d(p), turn, V3d(0.5, 0.8, 1)), object});
    }
  }
  return flat;
}

/// Clutter that stands still and that moves, and uses of a mesh in both.
struct Crowd {
  Crowd() : meshes{Icosphere(2)} {
    geometry = MakeGeometry(With(Clutter(150, 0), 20, 0), meshes);
    Move(0);
    for (std::size_t i = 0; i < geometry.objects.size(); ++i) {
      transmittance.push_back(Rgb(i % 3 == 0 ? 0.5f : 0));
    }
  }

  void Move(std::uint32_t seed) {
    ReplaceMoving(With(Clutter(20, 7000 + seed), 5, 500 + seed), &geometry);
  }

  static FlatScene With(FlatScene flat, std::uint32_t uses,
                        std::uint32_t seed) {
    for (std::uint32_t i = seed; i < seed + uses; ++i) {
      const Affined place = PositionRotateScale(
          V3d(RandomDirection(i) * 7.0f), V3d(RandomDirection(i + 50) * 90.0f),
          V3d(0.5, 1, 0.8));
      flat.meshes.push_back({0, static_cast<Index>(flat.objects.size())});
      flat.objects.push_back({kNone, place});
    }
    return flat;
  }

  std::vector<TriangleMesh> meshes;
  Geometry geometry;
  std::vector<Rgb> transmittance;
};

Ray RandomRay(std::uint32_t i) {
  Ray ray;
  ray.origin = RandomDirection(i) * 14.0f;
  const V3f target = RandomDirection(i + 70000) * 9.0f;
  ray.direction = (target - ray.origin).normalized();
  if (i % 4 == 0) ray.t_max = 15 * testing::Uniform(i, 8, kSeed);
  return ray;
}

/// What is to be the same, bit for bit.
void ExpectSame(const Hit& a, const Hit& b) {
  EXPECT_EQ(a.kind, b.kind);
  EXPECT_EQ(a.primitive, b.primitive);
  EXPECT_EQ(a.use, b.use);
  EXPECT_EQ(a.t, b.t);
  EXPECT_EQ(a.u, b.u);
  EXPECT_EQ(a.v, b.v);
}

TEST(BvhAccelTest, AllInstructionSetsGiveTheBitsOfTheTracer) {
  Crowd crowd;
  const BvhAccel accel =
      BvhAccel::Build(crowd.geometry, crowd.transmittance).value();
  const BvhTracer tracer(accel.view());
  int hits = 0;
  for (std::uint32_t i = 0; i < 5000; ++i) {
    const Ray ray = RandomRay(i);
    const Hit hit = tracer.Closest(ray);
    hits += hit.kind != PrimitiveKind::kNothing;
    for (const BvhKernels& kernels : RunnableBvhKernels()) {
      SCOPED_TRACE(kernels.name);
      const HostBvhTracer host(accel.view(), kernels);
      ExpectSame(host.Closest(ray), hit);
      EXPECT_EQ(host.Occluded(ray), tracer.Occluded(ray));
      EXPECT_EQ(host.Transmittance(ray), tracer.Transmittance(ray));
    }
  }
  EXPECT_GT(hits, 2000);
}

TEST(BvhAccelTest, FindsWhatEmbreeFinds) {
  Crowd crowd;
  const BvhAccel bvh =
      BvhAccel::Build(crowd.geometry, crowd.transmittance).value();
  const EmbreeAccel embree =
      EmbreeAccel::Build(crowd.geometry, crowd.transmittance).value();
  int differing = 0, kinds[6] = {};
  for (std::uint32_t i = 0; i < 20000; ++i) {
    const Ray ray = RandomRay(i);
    const Hit a = bvh.Closest(ray), b = embree.Closest(ray);
    ++kinds[static_cast<int>(a.kind)];
    const bool same = a.kind == b.kind && a.primitive == b.primitive &&
                      a.use == b.use &&
                      (a.kind == PrimitiveKind::kNothing ||
                       std::abs(a.t - b.t) <= 1e-5f * b.t) &&
                      bvh.Occluded(ray) == embree.Occluded(ray) &&
                      bvh.Transmittance(ray) == embree.Transmittance(ray);
    differing += !same;
  }
  EXPECT_LE(differing, 4);  // rays along an edge
  for (const auto kind :
       {PrimitiveKind::kNothing, PrimitiveKind::kTriangle, PrimitiveKind::kMesh,
        PrimitiveKind::kSphere, PrimitiveKind::kDisk}) {
    EXPECT_GT(kinds[static_cast<int>(kind)], 100) << static_cast<int>(kind);
  }
}

TEST(BvhAccelTest, AnUpdateEqualsAFreshBuild) {
  Crowd crowd;
  BvhAccel moved = BvhAccel::Build(crowd.geometry, crowd.transmittance).value();
  const BvhNode* still = moved.still().nodes.data();
  const BvhNode* meshes = moved.meshes().nodes.data();
  crowd.Move(300);
  ASSERT_TRUE(moved.Update(crowd.transmittance).has_value());
  EXPECT_EQ(moved.still().nodes.data(), still);
  EXPECT_EQ(moved.meshes().nodes.data(), meshes);
  const BvhAccel fresh =
      BvhAccel::Build(crowd.geometry, crowd.transmittance).value();
  for (std::uint32_t i = 0; i < 5000; ++i) {
    const Ray ray = RandomRay(i);
    ExpectSame(moved.Closest(ray), fresh.Closest(ray));
    EXPECT_EQ(moved.Transmittance(ray), fresh.Transmittance(ray));
  }
}

template <class T>
bool SameBytes(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() &&
         std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

/// Many small triangles in one place, and as many in another.
void AddHeaps(FlatScene* flat) {
  for (int i = 0; i < 20000; ++i) {
    const V3f p(0, i % 2 == 0 ? 20.0f : -20.0f, 0);
    flat->triangles.push_back({{p, p + V3f(1, 0, 0), p + V3f(0, 1, 0)}, 0});
  }
}

TEST(BvhAccelTest, TheSameForAnyNumberOfThreads) {
  std::vector<TriangleMesh> meshes{Icosphere(5)};  // 20480 triangles
  FlatScene flat = Clutter(4000, 0);
  AddHeaps(&flat);
  flat.meshes.push_back({0, 0});
  Geometry geometry = MakeGeometry(flat, meshes);
  const std::vector<Rgb> opaque(geometry.objects.size(), Rgb(0));
  const BvhAccel one = BvhAccel::Build(geometry, opaque, 1).value();
  const BvhAccel all = BvhAccel::Build(geometry, opaque, 0).value();
  EXPECT_TRUE(SameBytes(one.still().nodes, all.still().nodes));
  EXPECT_TRUE(SameBytes(one.still().packs, all.still().packs));
  EXPECT_TRUE(SameBytes(one.meshes().nodes, all.meshes().nodes));
  EXPECT_TRUE(SameBytes(one.meshes().packs, all.meshes().packs));
}

TEST(BvhAccelTest, RaysThatAreNoneMeetNothing) {
  Crowd crowd;
  const BvhAccel accel =
      BvhAccel::Build(crowd.geometry, crowd.transmittance).value();
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  constexpr float kInf = std::numeric_limits<float>::infinity();
  std::vector<Ray> rays;
  for (const float bad : {kNan, kInf, -kInf}) {
    for (int axis = 0; axis < 3; ++axis) {
      rays.emplace_back().origin[axis] = bad;
      rays.emplace_back().direction[axis] = bad;
    }
  }
  rays.emplace_back().direction = V3f(0);
  for (const float t_max : {kNan, 0.0f, -1.0f}) {
    rays.emplace_back().t_max = t_max;
  }
  for (const BvhKernels& kernels : RunnableBvhKernels()) {
    const HostBvhTracer tracer(accel.view(), kernels);
    for (const Ray& ray : rays) {
      EXPECT_EQ(tracer.Closest(ray).kind, PrimitiveKind::kNothing);
      EXPECT_FALSE(tracer.Occluded(ray));
      EXPECT_EQ(tracer.Transmittance(ray), Rgb(1));
    }
  }
}

}  // namespace
}  // namespace rtb
