// What rough metal shows of lights with extent, by the Whitted integrator: its
// points of lights and its rays of the lobe are weighed against each other, and
// must together bring what either way brings alone. The metal is the plane
// y = 0, seen at the origin.
#include "core/render/lobe_light.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "core/shading/shading_scene.h"
#include "tests/core/render/measure.h"

namespace rtb {
namespace {

using testing::By;
using testing::CenterEstimate;
using testing::Estimate;
using testing::SceneBuilder;

const V3d kEye(1.2, 1.5, 0.4);
constexpr float kGreen = 0.7f;

SceneBuilder MetalUnder(double roughness) {
  SceneBuilder b;
  const Index metal = b.Add(Metal{Rgb(1, kGreen, 0.3f), roughness});
  b.Add(Plane{V3d(0), V3d(0, 1, 0)}, metal);
  b.Look(kEye, V3d(0));
  return b;
}

/// Around the eye's mirror image, and much more; it shines down.
const QuadLight kQuad{
    V3d(-2.5, 2, -1.5), {V3d(1.5, 0, 0), V3d(0, 0, 1.3)}, Rgb(3), 8};
const SphereLight kSphere{V3d(-1.5, 2.2, -0.7), 0.5, Rgb(3), 8};
/// Hides a part of either light from the origin.
const Quad kOccluder{V3d(-0.75, 1, -1), {V3d(0.4, 0, 0), V3d(0, 0, 2)}};

double Cross(const V3d& a, const V3d& b, const V3d& n) {
  return a.cross(b).dot(n);
}

/// Whether the ray from the origin meets a parallelogram, from any side.
bool Meets(const V3d& d, const V3d& corner, const V3d& e0, const V3d& e1) {
  const V3d n = e0.cross(e1);
  const V3d p = d * (corner.dot(n) / d.dot(n)) - corner;
  const double u = Cross(p, e1, n) / n.dot(n);
  const double v = Cross(e0, p, n) / n.dot(n);
  return p.dot(d) > -corner.dot(d) && u >= 0 && u <= 1 && v >= 0 && v <= 1;
}

bool MeetsQuad(const V3d& d) {
  return Meets(d, kQuad.corner, kQuad.edges[0], kQuad.edges[1]);
}
bool MeetsSphere(const V3d& d) {
  const double along = d.dot(kSphere.center);
  const double aside = kSphere.center.length2() - along * along;
  return along > 0 && aside < kSphere.radius * kSphere.radius;
}
bool MeetsOccluder(const V3d& d) {
  return Meets(d, kOccluder.corner, kOccluder.edges[0], kOccluder.edges[1]);
}

/// Green at the origin by plain chance: directions of the lobe, 3 times the
/// weight of those that meet the light.
Estimate ByLobeAlone(double roughness,
                     const std::function<bool(const V3d&)>& meets) {
  const GgxEnergy table = MakeGgxEnergy();
  const GgxEnergyView energy = ViewOf(table);
  const BsdfData bsdf = MakeBsdf(SurfaceModel::kMetal, Rgb(1, kGreen, 0.3f),
                                 1.5f, static_cast<float>(roughness), energy);
  const V3d out = kEye.normalized();
  // The frame's z is the world's y: (x, y, z) there is (x, z, -y) here.
  const V3f wo(V3d(out.x, -out.z, out.y));
  std::mt19937 random(5);
  const auto uniform = [&] {
    return static_cast<float>(random() >> 8) * 0x1p-24f;
  };
  std::vector<double> values;
  for (int i = 0; i < 1000000; ++i) {
    const float u = uniform(), v = uniform();
    const BsdfSample sample = SampleGlossy(bsdf, energy, wo, V2f(u, v));
    const V3d d(sample.wi.x, sample.wi.z, -sample.wi.y);
    values.push_back(sample.pdf > 0 && meets(d) ? 3 * sample.weight.y : 0);
  }
  return testing::EstimateOf(values);
}

void ExpectSame(const Estimate& actual, const Estimate& expected,
                const std::string& what) {
  EXPECT_NEAR(actual.mean, expected.mean,
              4 * std::hypot(actual.error, expected.error))
      << what;
  EXPECT_LT(actual.error, 0.005 * expected.mean) << what;
  EXPECT_LT(expected.error, 0.004 * expected.mean) << what;
}

/// Points of lights alone (depth 0: there is no lobe ray), both ways, and the
/// path integrator's two ways, against the lobe alone.
void ExpectUnbiased(double roughness, bool quad, bool hidden) {
  SceneBuilder b = MetalUnder(roughness);
  if (quad) {
    b.AddLight(kQuad);
  } else {
    b.AddLight(kSphere);
  }
  if (hidden) b.Add(kOccluder, b.Add(Lambertian{Rgb(0)}));
  const Estimate expected = ByLobeAlone(roughness, [&](const V3d& d) {
    if (hidden && MeetsOccluder(d)) return false;
    return quad ? MeetsQuad(d) : MeetsSphere(d);
  });
  for (const RenderOptions& options :
       {By("whitted", 0, 1024), By("whitted", 1, 64), By("path", 1, 1024)}) {
    ExpectSame(CenterEstimate(b, options, 32), expected,
               options.integrator + std::to_string(options.max_depth) +
                   " roughness " + std::to_string(roughness));
  }
}

TEST(LobeLightTest, QuadLightAsByTheLobeAlone) {
  ExpectUnbiased(0.1, true, false);
  ExpectUnbiased(0.4, true, false);
}

TEST(LobeLightTest, SphereLightAsByTheLobeAlone) {
  ExpectUnbiased(0.1, false, false);
  ExpectUnbiased(0.4, false, false);
}

TEST(LobeLightTest, HiddenLightsAsByTheLobeAlone) {
  for (const double roughness : {0.1, 0.4}) {
    ExpectUnbiased(roughness, true, true);
    ExpectUnbiased(roughness, false, true);
  }
}

/// Rough metal around both lights, and a mirror: what arrives at the eye does
/// so by these alone, which both integrators follow.
SceneBuilder MetalRoom() {
  SceneBuilder b = MetalUnder(0.3);
  const Index other = b.Add(Metal{Rgb(0.9f, 0.8f, 0.6f), 0.15});
  b.Add(Plane{V3d(0, 0, -2), V3d(0, 0, 1)}, other);
  b.Add(Plane{V3d(-3, 0, 0), V3d(1, 0, 0)}, other);
  b.Add(Plane{V3d(2, 0, 0), V3d(-1, 0, 0)}, b.Add(Mirror{Rgb(0.3f)}));
  b.AddLight(kQuad);
  b.AddLight(SphereLight{V3d(0.4, 0.8, -1.2), 0.3, Rgb(2), 5});
  return b;
}

void ExpectAsByPaths(const SceneBuilder& b, int depth) {
  ExpectSame(CenterEstimate(b, By("whitted", depth, 64), 32),
             CenterEstimate(b, By("path", depth, 2048), 32),
             "depth " + std::to_string(depth));
}

TEST(LobeLightTest, ChainsOfLobesAsByPaths) {
  const SceneBuilder b = MetalRoom();
  for (const int depth : {1, 2, 3}) ExpectAsByPaths(b, depth);
}

TEST(LobeLightTest, LobesInAMirrorAsByPaths) {
  // The mirror's image of the origin is (4, 0, 0); the eye's is at 2 kEye.
  SceneBuilder b = MetalRoom();
  b.Look(V3d(4 - 2 * kEye.x, 2 * kEye.y, 2 * kEye.z), V3d(4, 0, 0));
  for (const int depth : {1, 2, 3}) ExpectAsByPaths(b, depth);
}

/// Of single eye rays, by points alone over both ways. 16 lobe rays are added
/// to 8 points: a factor of 3 would follow from the numbers alone, were the
/// two ways as good.
double VarianceRatio(double roughness, bool hidden) {
  SceneBuilder b = MetalUnder(roughness);
  b.AddLight(kQuad);
  if (hidden) b.Add(kOccluder, b.Add(Lambertian{Rgb(0)}));
  const double points = CenterEstimate(b, By("whitted", 0, 1), 2048).error;
  const double both = CenterEstimate(b, By("whitted", 1, 1), 2048).error;
  return points * points / (both * both);
}

TEST(LobeLightTest, VarianceOfNarrowLobesFallsFarBelowThatOfPoints) {
  EXPECT_GT(VarianceRatio(0.1, false), 100);
  EXPECT_GT(VarianceRatio(0.1, true), 10);
  EXPECT_GT(VarianceRatio(0.3, false), 3);
}

/// A dark metal whose lobe weighs 0.05, each of its 16 rays 0.003.
SceneBuilder DarkMetal() {
  SceneBuilder b;
  const Index metal = b.Add(Metal{Rgb(0.05f), 0.3});
  b.Add(Plane{V3d(0), V3d(0, 1, 0)}, metal);
  b.AddLight(kQuad);
  b.SetBackground(Rgb(2));
  b.Look(kEye, V3d(0));
  return b;
}

TEST(LobeLightTest, LobesAreDroppedByTheirWeightNotTheirRays) {
  const SceneBuilder b = DarkMetal();
  RenderOptions options = By("whitted", 1);
  const Rgb all = b.Center(options);
  options.least_weight = 1.0f / 256;
  EXPECT_EQ(b.Center(options), all);
}

TEST(LobeLightTest, PointsOfLightsBringAllWhereTheLobeIsDropped) {
  const SceneBuilder b = DarkMetal();
  RenderOptions options = By("whitted", 1);
  options.least_weight = 0.2f;
  EXPECT_EQ(b.Center(options), b.Center(By("whitted", 0)));
}

}  // namespace
}  // namespace rtb
