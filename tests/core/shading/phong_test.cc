#include "core/shading/phong.h"

#include <gtest/gtest.h>

#include "tests/core/shading/bsdf_cases.h"

namespace rtb {
namespace {

BsdfData Shiny() {
  BsdfData phong = MakeBsdf(SurfaceModel::kPhong, Rgb(0.5f), 1, 0, {});
  phong.specular = Rgb(0.5f, 1, 0);
  phong.exponent = 3;
  return phong;
}

TEST(EvalPhongTest, HighlightAroundTheMirrorDirection) {
  // Viewer and light 30 degrees from the normal on the same side: the mirror
  // direction is 60 degrees from the light, 0.5^3 = 1/8 of the peak.
  const V3f w(0.5f, 0, std::sqrt(0.75f));
  const Rgb aside = EvalPhong(Shiny(), w, w);
  EXPECT_NEAR(aside.x, 0.5 / 8 / 3.14159265, 1e-6);
  EXPECT_NEAR(aside.y, 1.0 / 8 / 3.14159265, 1e-6);
  EXPECT_EQ(aside.z, 0);
  const Rgb peak = EvalPhong(Shiny(), w, V3f(-w.x, 0, w.z));
  EXPECT_NEAR(peak.y, 1 / 3.14159265, 1e-6);
}

TEST(EvalPhongTest, BlackFromBehindAndPastARightAngle) {
  const V3f up(0, 0, 1);
  EXPECT_EQ(EvalPhong(Shiny(), up, DirectionAt(-0.1f)), Rgb(0));
  EXPECT_EQ(EvalPhong(Shiny(), DirectionAt(-0.1f), up), Rgb(0));
  // Both at 60 degrees on one side: the mirror direction is 120 degrees off.
  EXPECT_EQ(EvalPhong(Shiny(), DirectionAt(0.5f), DirectionAt(0.5f)), Rgb(0));
}

TEST(EvalPhongTest, AlbedoIsLambertian) {
  EXPECT_NEAR(EvalDiffuse(Shiny(), V3f(0, 0, 1), DirectionAt(0.5f)).x,
              0.5 / 3.14159265, 1e-6);
}

}  // namespace
}  // namespace rtb
