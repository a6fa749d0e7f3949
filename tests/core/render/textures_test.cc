// Textures, bumps and checkers as a rendered picture shows them.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "core/image/io.h"
#include "tests/core/render/measure.h"
#include "tests/temp_folder.h"

namespace rtb {
namespace {

using testing::By;
using testing::SceneBuilder;

const Rgb kRed(1, 0, 0), kGreen(0, 1, 0), kBlue(0, 0, 1), kWhite(1, 1, 1);

/// 2 x 2 texels, red and green above blue and white, in a file of its own.
class TexturesTest : public ::testing::Test {
 protected:
  void SetUp() override {
    file_ = folder_ / "four_texels.exr";
    Image image(2, 2);
    image.at(0, 0) = kRed;
    image.at(1, 0) = kGreen;
    image.at(0, 1) = kBlue;
    image.at(1, 1) = kWhite;
    ASSERT_TRUE(WriteExr(file_, image, ExrType::kFloat).has_value());
  }
  /// A scene whose material 0 shows the image; ambient 1 makes it emit its
  /// albedo.
  SceneBuilder Textured() const {
    SceneBuilder b;
    b.Add(Lambertian{}, ImageTexture{file_, V2d(1, 1)});
    b.scene.settings.ambient = Rgb(1);
    return b;
  }

  /// The color where a ray from `eye` meets `target`.
  static Rgb Seen(SceneBuilder b, const V3d& target, const V3d& eye) {
    b.Look(eye, target);
    return b.Center(By("whitted", 0));
  }

  /// At texel centers there is no interpolation: (u, v) of a quarter or three
  /// quarters, v upwards.
  static void ExpectFour(const SceneBuilder& b, const V3d& eye,
                         const std::function<V3d(double, double)>& at) {
    const struct {
      double u, v;
      Rgb color;
    } cases[] = {{0.25, 0.75, kRed},
                 {0.75, 0.75, kGreen},
                 {0.25, 0.25, kBlue},
                 {0.75, 0.25, kWhite}};
    for (const auto& c : cases) {
      EXPECT_LT((Seen(b, at(c.u, c.v), eye) - c.color).length(), 1e-3f)
          << c.u << " " << c.v;
    }
  }

  TempFolder folder_;
  std::filesystem::path file_;
};

// Each pixel's beam covers 8 x 8 repetitions of the image, of which one ray
// sees the mean, (1 + 0 + 0 + 1) / 4 of each color; by a mirror too.
TEST_F(TexturesTest, RaysSeeTheMeanOfWhatTheyStandFor) {
  SceneBuilder direct = Textured();
  direct.scene.materials[0].texture = ImageTexture{file_, V2d(80, 80)};
  direct.Add(Quad{V3d(-20, -20, 0), {V3d(40, 0, 0), V3d(0, 40, 0)}}, 0);
  SceneBuilder mirrored = direct;
  direct.Look(V3d(0, 0, 10), V3d(0, 0, 0));
  // Looks away from the quad, at a mirror 5 behind.
  mirrored.Add(Quad{V3d(-20, -20, 10), {V3d(40, 0, 0), V3d(0, 40, 0)}},
               mirrored.Add(Mirror{}));
  mirrored.Look(V3d(0, 0, 5), V3d(0, 0, 10));
  for (SceneBuilder* b : {&direct, &mirrored}) {
    b->scene.camera.vfov = 90;
    b->SetBackground(Rgb(1));
    // The sky does not reach between the mirror and the quad.
    for (const char* integrator : {"whitted", "path"}) {
      if (b == &mirrored && integrator == std::string("path")) break;
      const Fragments seen = b->Render(PixelPlan(5, 5), By(integrator, 2));
      for (const Rgb& color : seen.values) {
        EXPECT_GT(color.y, 0) << integrator;
        EXPECT_NEAR(color.x / color.y, 1, 0.05f) << integrator << color;
        EXPECT_NEAR(color.z / color.y, 1, 0.05f) << integrator << color;
      }
    }
  }
}

TEST_F(TexturesTest, QuadAlongItsEdges) {
  SceneBuilder b = Textured();
  const V3d corner(-1, 0, 2), e0(2, 0.5, 0), e1(0.3, 3, -1);
  b.Add(Quad{corner, {e0, e1}}, 0);
  ExpectFour(b, V3d(0, 1, 9),
             [&](double u, double v) { return corner + e0 * u + e1 * v; });
}

TEST_F(TexturesTest, BoxFacesAsQuadsSeenFromOutside) {
  // Each side seen from outside with y up: u to the viewer's right.
  SceneBuilder b = Textured();
  b.Add(Box{V3d(-1), V3d(1)}, 0);
  const struct {
    V3d out, right;
  } sides[] = {{V3d(0, 0, 1), V3d(1, 0, 0)},
               {V3d(1, 0, 0), V3d(0, 0, -1)},
               {V3d(0, 0, -1), V3d(-1, 0, 0)},
               {V3d(-1, 0, 0), V3d(0, 0, 1)}};
  for (const auto& s : sides) {
    ExpectFour(b, s.out * 5.0, [&](double u, double v) {
      return s.out + s.right * (2 * u - 1) + V3d(0, 2 * v - 1, 0);
    });
  }
}

TEST_F(TexturesTest, SphereByLongitudeAndLatitude) {
  // u = 0.5 + atan2(-z, x) / 2 pi, v = 0.5 + asin(y) / pi: u = 1/4 lies at
  // angle -90 degrees, which is +z; u = 3/4 at -z; v = 3/4 45 degrees up.
  SceneBuilder b = Textured();
  b.Add(Sphere{V3d(1, 2, 3), 2}, 0);
  for (const double u : {0.25, 0.75}) {
    for (const double v : {0.25, 0.75}) {
      const double h = std::sqrt(0.5);
      const V3d out(0, v > 0.5 ? h : -h, u < 0.5 ? h : -h);
      const Rgb expected =
          v > 0.5 ? (u < 0.5 ? kRed : kGreen) : (u < 0.5 ? kBlue : kWhite);
      const V3d target = V3d(1, 2, 3) + out * 2.0;
      EXPECT_LT((Seen(b, target, target + out * 4.0) - expected).length(),
                1e-3f)
          << u << " " << v;
    }
  }
}

TEST_F(TexturesTest, TriangleAndPolygonByBarycentrics) {
  // u, v = the weights of the second and third corner.
  const V3d a(-1, -1, 0), c(2, 0, 0), d(0, 3, 0);
  SceneBuilder triangle = Textured();
  triangle.Add(Triangle{{a, a + c, a + d}}, 0);
  const auto at = [&](double u, double v) { return a + c * u + d * v; };
  const V3d eye(0, 0, 9);
  EXPECT_LT((Seen(triangle, at(0.25, 0.25), eye) - kBlue).length(), 1e-3f);
  EXPECT_LT((Seen(triangle, at(0.2499, 0.7499), eye) - kRed).length(), 3e-3f);
  EXPECT_LT((Seen(triangle, at(0.7499, 0.2499), eye) - kWhite).length(), 3e-3f);
  // A polygon goes on in the first triangle's frame.
  SceneBuilder polygon = Textured();
  polygon.Add(Polygon{{a, a + c, a + d, at(-0.4, 0.9), at(-0.6, 0.3)}}, 0);
  EXPECT_LT((Seen(polygon, at(0.25, 0.25), eye) - kBlue).length(), 1e-3f);
  EXPECT_LT((Seen(polygon, at(-0.25, 0.75), eye) - kGreen).length(), 1e-3f);
  EXPECT_LT((Seen(polygon, at(-0.25, 0.25), eye) - kWhite).length(), 1e-3f);
}

TEST_F(TexturesTest, DisksAndPlanesInSceneUnitsAroundTheirNormal) {
  // Duff et al. around n = (0, 0, 1): sign = 1, a = -1/2, b = 0: s = (1, 0,
  // 0), t = (0, 1, 0). Around (0, 0, -1): sign = -1, a = 1/2: s = (1, 0, 0),
  // t = (0, -1, 0). Around +y: sign = 1, a = -1, b = 0: s = (1, 0, 0),
  // t = (0, 0, -1).
  const struct {
    V3d n, s, t;
  } cases[] = {{V3d(0, 0, 1), V3d(1, 0, 0), V3d(0, 1, 0)},
               {V3d(0, 0, -1), V3d(1, 0, 0), V3d(0, -1, 0)},
               {V3d(0, 1, 0), V3d(1, 0, 0), V3d(0, 0, -1)}};
  for (const auto& c : cases) {
    for (const bool disk : {false, true}) {
      SceneBuilder b = Textured();
      const V3d at(0.5, 0.2, -0.3);
      if (disk) {
        b.Add(Disk{at, c.n * 3.0, 4}, 0);
      } else {
        b.Add(Plane{at, c.n * 3.0}, 0);
      }
      ExpectFour(b, at + c.n * 5.0 + c.s * 0.1, [&](double u, double v) {
        return at + c.s * (u + 1) + c.t * (v - 2);  // repeated
      });
    }
  }
}

TEST_F(TexturesTest, MeshesBringTheirOwnAndScaleMultiplies) {
  TriangleMesh mesh;
  mesh.positions = {V3f(-1, -1, 0), V3f(1, -1, 0), V3f(1, 1, 0), V3f(-1, 1, 0)};
  // Turned by a quarter: u runs up, v to the left.
  mesh.uvs = {V2f(0, 1), V2f(0, 0), V2f(1, 0), V2f(1, 1)};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  SceneBuilder b = Textured();
  b.Add(mesh, 0);
  const V3d eye(0, 0, 5);
  ExpectFour(b, eye,
             [](double u, double v) { return V3d(1 - 2 * v, 2 * u - 1, 0); });
  b.scene.materials[0].texture = ImageTexture{file_, V2d(2, 3)};
  ExpectFour(b, eye, [](double u, double v) {
    return V3d(1 - 2 * (v + 2) / 3, 2 * (u + 1) / 2 - 1, 0);
  });
}

// Cells of 1 in the object's own coordinates, so of 0.5 in the world under
// scale 1/2: an instance carries its checker along.
TEST_F(TexturesTest, CheckersGoWithInstances) {
  SceneBuilder b;
  const Index m = b.Add(Lambertian{}, CheckerTexture{kRed, kBlue, 1});
  b.scene.settings.ambient = Rgb(1);
  Object quad;
  quad.shape = Quad{V3d(0, 0, 0.5), {V3d(2, 0, 0), V3d(0, 2, 0)}};
  quad.material = m;
  Object group;
  group.id = "board";
  group.shape = Group{};
  group.children = {quad};
  group.position = V3d(-9, 0, 0);
  b.scene.objects.push_back(group);
  Object copy;
  copy.shape = Instance{"board"};
  copy.position = V3d(3, 1, 0);
  copy.rotate = V3d(0, 0, 90);
  copy.scale = V3d(0.5);
  b.scene.objects.push_back(copy);
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 2; ++j) {
      const Rgb expected = (i + j) % 2 == 0 ? kRed : kBlue;
      const V3d own(i + 0.4, j + 0.7, 0.5);
      // A quarter turn takes (x, y) to (-y, x).
      const V3d world(3 - own.y / 2, 1 + own.x / 2, 0.25);
      EXPECT_EQ(Seen(b, world, world + V3d(0, 0, 5)), expected);
      const V3d original = own + V3d(-9, 0, 0);
      EXPECT_EQ(Seen(b, original, original + V3d(0, 0, 5)), expected);
    }
  }
}

// A height that rises to the right on a quad that faces the viewer leans the
// normal to the left: light from the left gets brighter, from the right
// darker, from above it stays. Heights 0, 1/4, 1/2, 3/4 of 4 texels over 4
// units with amount 1 rise by 1/4 per unit: the normal is (-1/4, 0, 1).
TEST_F(TexturesTest, BumpsTiltTheRightWay) {
  const auto file = folder_ / "rising.exr";
  for (const bool upwards : {false, true}) {
    Image heights(4, 4);
    for (int y = 0; y < 4; ++y) {
      for (int x = 0; x < 4; ++x) {
        const int along = upwards ? 3 - y : x;
        heights.at(x, y) = Rgb(0.25f * static_cast<float>(along));
      }
    }
    ASSERT_TRUE(WriteExr(file, heights, ExrType::kFloat).has_value());
    for (const double scale : {1.0, 2.0}) {
      for (const V3d& from :
           {V3d(-1, 0, 1), V3d(1, 0, 1), V3d(0, 1, 1), V3d(0, -1, 1)}) {
        SceneBuilder b;
        b.Add(Lambertian{Rgb(1)});
        b.scene.materials[0].bump = BumpMap{file, 1};
        b.Add(Quad{V3d(-2, -2, 0), {V3d(4, 0, 0), V3d(0, 4, 0)}}, 0).scale =
            V3d(scale);
        const V3d l = from.normalized();
        b.AddLight(
            DirectionalLight{-l, Rgb(static_cast<float>(testing::kPiExact))});
        const V3d lean = upwards ? V3d(0, -1, 0) : V3d(-1, 0, 0);
        // Scaled, the same height spreads over twice the length.
        const V3d n = (V3d(0, 0, 1) + lean * (0.25 / scale)).normalized();
        EXPECT_NEAR(Seen(b, V3d(0.1, 0.1, 0), V3d(0, 0, 9)).y, n.dot(l), 1e-4)
            << upwards << " " << scale << " " << from.x << " " << from.y;
      }
    }
  }
}

}  // namespace
}  // namespace rtb
