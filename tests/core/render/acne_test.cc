// Shadow acne: lit convex bodies have no dark pixel where they are lit, at any
// size, far from the origin, placed and instanced.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/render/measure.h"
#include "tests/core/scene/mesh_shapes.h"

namespace rtb {
namespace {

using testing::By;
using testing::SceneBuilder;

enum class Body { kSphere, kBox, kFacets, kSmooth, kInstance, kSqueezed };
constexpr Body kBodies[] = {Body::kSphere, Body::kBox,      Body::kFacets,
                            Body::kSmooth, Body::kInstance, Body::kSqueezed};

/// A white body about the size of the unit sphere, at `offset` times `scale`.
SceneBuilder Lit(Body body, double scale, const V3d& offset) {
  SceneBuilder b;
  const Index white = b.Add(Lambertian{Rgb(1)});
  if (body == Body::kSphere) b.Add(Sphere{V3d(0), 1}, white);
  if (body == Body::kBox) b.Add(Box{V3d(-0.7), V3d(0.6)}, white);
  if (body == Body::kFacets) b.Add(Icosphere(2), white);
  if (body >= Body::kSmooth) b.Add(SmoothIcosphere(2), white);
  Object& object = b.scene.objects.back();
  object.position = offset * scale;
  object.scale = V3d(scale);
  object.rotate = V3d(10, 20, 30);
  if (body == Body::kSqueezed) object.scale = V3d(1, 0.2, 0.7) * scale;
  if (body == Body::kInstance) {
    object.id = "body";
    Object copy = object;
    copy.id = "";
    copy.shape = Instance{"body"};
    object.position = (offset + V3d(0, 40, 0)) * scale;
    b.scene.objects.push_back(copy);
  }
  b.scene.camera.vfov = 24;
  b.Look((offset + V3d(1, 2, 6)) * scale, offset * scale);
  return b;
}

/// Pixels of the body that the light leaves black.
int DarkPixels(SceneBuilder b, const decltype(Light::kind)& light) {
  const SamplePlan plan = PixelPlan(96, 96);
  b.scene.settings.ambient = Rgb(1);
  const Fragments mask = b.Render(plan, By("whitted", 0));
  b.scene.settings.ambient = Rgb(0);
  b.AddLight(light);
  const Fragments lit = b.Render(plan, By("whitted", 0));
  int body = 0, dark = 0;
  for (std::size_t i = 0; i < mask.values.size(); ++i) {
    if (!(mask.values[i].x > 0)) continue;
    ++body;
    dark += !(lit.values[i].x > 0);
  }
  EXPECT_GT(body, 600);
  return dark;
}

// The light comes from the eye: every visible point is lit.
TEST(AcneTest, NoVisiblePointIsDarkUnderALightAtTheEye) {
  for (const Body body : kBodies) {
    for (const double scale : {1e-3, 1.0, 1e3, 1e6}) {
      for (const V3d& offset : {V3d(0), V3d(30, -20, 50)}) {
        const SceneBuilder b = Lit(body, scale, offset);
        EXPECT_EQ(
            DarkPixels(b, DirectionalLight{b.scene.camera.direction, Rgb(1)}),
            0)
            << static_cast<int>(body) << " " << scale << " " << offset.x;
        EXPECT_EQ(
            DarkPixels(b, PointLight{b.scene.camera.position, Rgb(1), false}),
            0)
            << static_cast<int>(body) << " " << scale << " " << offset.x;
      }
    }
  }
}

// From aside, the picture is the same at every scale: shadows of the body on
// itself would come and go with rounding.
TEST(AcneTest, TheTerminatorIsTheSameAtEveryScale) {
  for (const Body body : kBodies) {
    std::vector<Fragments> pictures;
    for (const double scale : {1.0, 1e-3, 1e3, 1e6}) {
      SceneBuilder b = Lit(body, scale, V3d(0));
      b.AddLight(DirectionalLight{V3d(-1, -0.1, -0.2), Rgb(1)});
      pictures.push_back(b.Render(PixelPlan(96, 96), By("whitted", 0)));
      EXPECT_LE(testing::CountOff(pictures[0], pictures.back(), 1e-3f), 46)
          << static_cast<int>(body) << " " << scale;  // 0.5 %: edges
    }
  }
}

// A plane under light that grazes it by a tenth of a degree, both ways of
// holding it, seen from near.
TEST(AcneTest, GrazingLightOnAFlatFloor) {
  const double a = 0.1 * testing::kPiExact / 180;
  const V3d travel(std::cos(a), -std::sin(a), 0);
  for (const bool quad : {false, true}) {
    SceneBuilder b;
    const Index white = b.Add(Lambertian{Rgb(1)});
    if (quad) {
      b.Add(Quad{V3d(-9, 0.3, -9), {V3d(0, 0, 18), V3d(18, 0, 0)}}, white);
    } else {
      b.Add(Plane{V3d(0, 0.3, 0), V3d(0, 1, 0)}, white);
    }
    b.AddLight(DirectionalLight{travel, Rgb(1000)});
    b.scene.camera.vfov = 24;
    b.Look(V3d(0, 2, 4), V3d(0, 0.3, 0));
    const double expected = 1000 * std::sin(a) / testing::kPiExact;
    for (const Rgb& v : b.Render(PixelPlan(48, 32), By("whitted", 0)).values) {
      EXPECT_NEAR(v.x, expected, 1e-3 * expected) << quad;
    }
  }
}

}  // namespace
}  // namespace rtb
