#include "reference/pov_export.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/reference/scene_maker.h"

namespace rtb {
namespace {

using testing::HasSubstr;
using testing::Not;

std::string Export(const Scene& scene, double time = 0) {
  const Result<std::string> text = ExportPov(scene, time);
  EXPECT_TRUE(text.has_value()) << text.error().ToString();
  return text.value_or("");
}

/// A scene about 400 units large, which is exported at its own scale.
Scene LargeScene() {
  Scene scene = MakeScene();
  AddObject(&scene, Sphere{V3d(0, 0, -200), 100});
  return scene;
}

/// The export of a large sphere of a material.
std::string ExportOf(decltype(Material::bsdf) bsdf, Texture texture = {}) {
  Scene scene = LargeScene();
  scene.objects[0].material = AddMaterial(&scene, bsdf, texture);
  return Export(scene);
}

TEST(PovExportTest, HeaderCountsTheEyeRayAndTurnsDefaultsOff) {
  Scene scene = LargeScene();
  scene.settings.max_depth = 5;
  const std::string text = Export(scene);
  EXPECT_THAT(text, HasSubstr("#version 3.7;\n"));
  EXPECT_THAT(text, HasSubstr("assumed_gamma 1.0 ambient_light rgb 0 "
                              "max_trace_level 6 adc_bailout 0"));
  EXPECT_THAT(text, HasSubstr("ambient rgb 0 emission rgb 0 diffuse 0 "
                              "specular 0 phong 0 brilliance 1"));
}

TEST(PovExportTest, CameraIsThreeVectorsAndShiftsByPass) {
  // vfov 90: both sides of the picture plane at distance 1 are 2 tan 45 = 2;
  // the tangent of pi/4 in double is 1 - 2^-53, so 2 comes out as 1.999...8.
  Scene scene = LargeScene();
  scene.camera.position = V3d(1, 2, 3);
  const std::string text = Export(scene);
  EXPECT_THAT(text, HasSubstr("  location <1, 2, 3>\n"));
  EXPECT_THAT(text, HasSubstr("Right = <1.9999999999999998, 0, 0> * "
                              "(image_width / image_height);\n"));
  EXPECT_THAT(text, HasSubstr("Up = <0, 1.9999999999999998, 0>;\n"));
  EXPECT_THAT(text, HasSubstr("  direction <0, 0, -1>\n    + Right * "));
  EXPECT_THAT(text, Not(HasSubstr("look_at")));
}

TEST(PovExportTest, ExportsSpheresAsTheUnitSphereUnderAMatrix) {
  EXPECT_THAT(Export(LargeScene()),
              HasSubstr("sphere { <0, 0, 0>, 1 matrix <100, 0, 0, 0, 100, 0, "
                        "0, 0, 100, 0, 0, -200> texture { pigment { rgb "
                        "<0.5, 0.5, 0.5> } finish { diffuse 1 } } }\n"));
}

TEST(PovExportTest, ScalesSmallScenesByAPowerOfTwo) {
  // The box of camera and sphere spans 2 x 2 x 4, diagonal sqrt(24) = 4.899;
  // 128 / 4.899 = 26.1, so 32. Intensity grows by 32^2:
  // 1024 / (2 pi 1e-8) = 1.6297466172610081e10.
  Scene scene = MakeScene();
  AddObject(&scene, Sphere{V3d(0, 0, -3), 1});
  AddLight(&scene, PointLight{V3d(0.5, 4, 0), Rgb(1, 2, 3), true});
  const std::string text = Export(scene);
  EXPECT_THAT(text, HasSubstr("lengths times 32\n"));
  EXPECT_THAT(text, HasSubstr("matrix <32, 0, 0, 0, 32, 0, 0, 0, 32, 0, 0, "
                              "-96>"));
  EXPECT_THAT(text, HasSubstr("light_source { <16, 128, 0> rgb <1, 2, 3> * "
                              "16297466172.61008"));
}

TEST(PovExportTest, ScalesLargeScenesDown) {
  // The sphere's box has the diagonal 20000 sqrt(3) = 34641, and
  // 1024 / 34641 = 0.0296; the next power of two is 0.03125.
  Scene scene = MakeScene();
  AddObject(&scene, Sphere{V3d(0), 10000});
  EXPECT_THAT(Export(scene), HasSubstr("lengths times 0.03125\n"));
}

TEST(PovExportTest, WritesPlanesDisksAndTriangles) {
  Scene scene = LargeScene();
  AddObject(&scene, Plane{V3d(5, -3, 7), V3d(0, 2, 0)});
  AddObject(&scene, Disk{V3d(1, 2, 3), V3d(0, 0, 5), 4});
  AddObject(&scene, Quad{V3d(0), {V3d(1, 0, 0), V3d(0, 1, 0)}});
  const std::string text = Export(scene);
  EXPECT_THAT(text, HasSubstr("plane { <0, 1, 0>, -3 texture"));
  EXPECT_THAT(text, HasSubstr("disc { <0, 0, 0>, <0, 0, 1>, 1 matrix <4, "));
  EXPECT_THAT(text, HasSubstr("mesh {\n"
                              "  triangle { <0, 0, 0>, <1, 0, 0>, <1, 1, 0> }\n"
                              "  triangle { <0, 0, 0>, <1, 1, 0>, <0, 1, 0> }\n"
                              "  inside_vector <0.36, 0.48, 0.8>\n"));
}

TEST(PovExportTest, WritesNormalsOfSmoothMeshes) {
  // A normal (1, 1, 0) under scale (2, 1, 1) turns by the inverse transpose to
  // (0.5, 1, 0) = sqrt(1.25) (0.4472136, 0.8944272, 0).
  Scene scene = LargeScene();
  TriangleMesh mesh;
  mesh.positions = {V3f(0), V3f(1, 0, 0), V3f(0, 1, 0)};
  mesh.normals = {V3f(1, 1, 0), V3f(0, 0, 1), V3f(0, 0, 1)};
  mesh.triangles = {{0, 1, 2}};
  scene.meshes.push_back(mesh);
  AddObject(&scene, Mesh{"m.obj", true, 0, 0}).scale = V3d(2, 1, 1);
  EXPECT_THAT(Export(scene),
              HasSubstr("smooth_triangle { <0, 0, 0>, <0.4472136, 0.8944272, "
                        "0>, <2, 0, 0>, <0, 0, 1>, <0, 1, 0>, <0, 0, 1> }"));
}

TEST(PovExportTest, WritesEveryMaterialItCanExpress) {
  EXPECT_THAT(ExportOf(Mirror{Rgb(0.9f, 0.8f, 0.7f)}),
              HasSubstr("reflection { rgb <0.9, 0.8, 0.7> }"));
  EXPECT_THAT(ExportOf(Metal{Rgb(0.9f, 0.8f, 0.7f), 0}),
              HasSubstr("reflection { rgb <0.9, 0.8, 0.7>, rgb 1 falloff 5 }"));
  EXPECT_THAT(ExportOf(Emissive{Rgb(15, 14, 13)}),
              HasSubstr("pigment { rgb <15, 14, 13> } finish { emission rgb 1 "
                        "}"));
  EXPECT_THAT(ExportOf(Dielectric{1.33, Rgb(1, 0.9f, 0.8f)}),
              HasSubstr("texture { pigment { rgbf <1, 0.9, 0.8, 1> } finish { "
                        "reflection { rgb 0, rgb 1 fresnel on } "
                        "conserve_energy } } interior { ior 1.33 }"));
  EXPECT_THAT(
      ExportOf(Phong{Rgb(0.1f), Rgb(0.5f), 60, Rgb(0.2f)}),
      HasSubstr("diffuse 1 phong 0.5 phong_size 60 reflection { rgb <0.2, "
                "0.2, 0.2> }"));
}

TEST(PovExportTest, AnIndexOfOneStillRefracts) {
  // POV-Ray passes rays through ior 1 without counting a level.
  EXPECT_THAT(ExportOf(Dielectric{1, Rgb(1)}),
              HasSubstr("interior { ior 1.000001 }"));
}

TEST(PovExportTest, AmbientIsEmissionOfDiffuseMaterialsAlone) {
  Scene scene = LargeScene();
  scene.settings.ambient = Rgb(0.1f, 0.2f, 0.3f);
  EXPECT_THAT(Export(scene),
              HasSubstr("diffuse 1 emission rgb <0.1, 0.2, 0.3> }"));
  scene.objects[0].material = AddMaterial(&scene, Mirror{Rgb(1)});
  EXPECT_THAT(Export(scene), Not(HasSubstr("emission rgb <")));
}

TEST(PovExportTest, ChecksOnASphereMoveAlongItsNormal) {
  // p/2 + 0.001 (p - c)/100 = (p - t)/u with 1/u = 0.5 + 1e-5 and
  // t = 1e-5 u c, c = (0, 0, -200): u = 1.99996..., t_z = -0.00399992...
  const std::string text =
      ExportOf(Lambertian{}, CheckerTexture{Rgb(1), Rgb(0), 2});
  EXPECT_THAT(
      text,
      HasSubstr("texture { checker texture { pigment { rgb <1, 1, 1> } finish "
                "{ diffuse 1 } } texture { pigment { rgb <0, 0, 0> } finish { "
                "diffuse 1 } } scale 1.9999600007999"));
  EXPECT_THAT(text, HasSubstr(" translate <0, 0, -0.003999920001599"));
  EXPECT_THAT(text, HasSubstr("> matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0>"));
}

TEST(PovExportTest, ChecksOnABoxSplitItByNormal) {
  Scene scene = LargeScene();
  const Index checker =
      AddMaterial(&scene, Lambertian{}, CheckerTexture{Rgb(1), Rgb(0), 2});
  AddObject(&scene, Box{V3d(0), V3d(1)}, checker);
  const std::string text = Export(scene);
  // p/2 + 0.001 n = (p - t)/2 with t = -0.002 n, for each of six normals.
  for (const char* t : {"<-0.002, 0, 0>", "<0, -0.002, 0>"}) {
    EXPECT_THAT(text, HasSubstr(std::string("scale 2 translate ") + t));
  }
  std::size_t meshes = 0;
  for (std::size_t at = 0; (at = text.find("mesh {", at)) != text.npos; ++at) {
    ++meshes;
  }
  EXPECT_EQ(meshes, 6u);
}

TEST(PovExportTest, WritesPointLights) {
  // 1 / (2 pi (1e-4)^2) = 15915494.309189532
  Scene scene = LargeScene();
  AddLight(&scene, PointLight{V3d(1, 2, 3), Rgb(4, 5, 6), true});
  AddLight(&scene, PointLight{V3d(1, 2, 3), Rgb(4, 5, 6), false});
  const std::string text = Export(scene);
  EXPECT_THAT(text, HasSubstr("light_source { <1, 2, 3> rgb <4, 5, 6> * "
                              "15915494.30918953"));
  EXPECT_THAT(text, HasSubstr(" fade_distance 1e-04 fade_power 2 }\n"));
  EXPECT_THAT(text,
              HasSubstr("light_source { <1, 2, 3> rgb <4, 5, 6> / pi }\n"));
}

TEST(PovExportTest, WritesDirectionalLightsFromFarAway) {
  Scene scene = LargeScene();
  AddLight(&scene, DirectionalLight{V3d(0, -2, 0), Rgb(1, 2, 3)});
  EXPECT_THAT(Export(scene),
              HasSubstr("light_source { <0, 1e+08, 0> rgb <1, 2, 3> / pi "
                        "parallel point_at <0, 0, 0> }\n"));
}

TEST(PovExportTest, WritesHardSpots) {
  Scene scene = LargeScene();
  AddLight(&scene, SpotLight{V3d(0, 9, 0), V3d(0, -3, 0), Rgb(1), 25, 0});
  EXPECT_THAT(Export(scene), HasSubstr("spotlight point_at <0, 8, 0> radius "
                                       "25 falloff 25 tightness 0 }"));
}

TEST(PovExportTest, APenumbraIsAShellAroundAPointLight) {
  // 20 + 5 degrees = 0.4363323129985824, 5 degrees = 0.08726646259971647.
  Scene scene = LargeScene();
  AddLight(&scene, SpotLight{V3d(0, 9, 0), V3d(0, -3, 0), Rgb(1), 20, 5});
  const std::string text = Export(scene);
  EXPECT_THAT(text, Not(HasSubstr("spotlight")));
  EXPECT_THAT(text, HasSubstr("min(1, (0.4363323129985824 - acos(max(-1, "
                              "min(1, x * 0 + y * -1 + z * 0)))) / "
                              "0.08726646259971647)"));
  EXPECT_THAT(text, HasSubstr("translate <0, 9, 0> no_image no_reflection }"));
}

TEST(PovExportTest, AreaLightsAreSeenAndShineByMacros) {
  // Power = radiance * area / (2 pi 1e-8): areas 2 * 3 = 6 and 4 pi 4.
  Scene scene = LargeScene();
  AddLight(&scene,
           QuadLight{V3d(1, 5, 0), {V3d(2, 0, 0), V3d(0, 0, 3)}, Rgb(1, 2, 3)});
  AddLight(&scene, SphereLight{V3d(0, 50, 0), 2, Rgb(1)});
  const std::string text = Export(scene);
  EXPECT_THAT(text, HasSubstr("#declare Emitters = 34;"));
  EXPECT_THAT(text,
              HasSubstr("QuadEmitters(<1, 5, 0>, <2, 0, 0>, <0, 0, 3>, <0, -1, "
                        "0>, rgb <6, 12, 18> * 15915494.30918953"));
  EXPECT_THAT(text, HasSubstr("sphere { <0, 50, 0>, 2 texture { pigment { rgb "
                              "<1, 1, 1> } finish { emission rgb 1 } } }\n"
                              "SphereEmitters(<0, 50, 0>, 2, rgb <50.2654"));
}

TEST(PovExportTest, ScenesWithoutAreaLightsNeedNoMacros) {
  EXPECT_THAT(Export(LargeScene()), Not(HasSubstr("#macro")));
}

TEST(PovExportTest, LightsFollowTheirPaths) {
  Scene scene = LargeScene();
  Path path;
  path.points = {V3d(0), V3d(10, 0, 0)};
  path.times = {0, 1};
  path.duration = 1;
  scene.paths.push_back(path);
  AddLight(&scene, PointLight{V3d(1, 2, 3), Rgb(1), false});
  scene.lights[0].path = 0;
  EXPECT_THAT(Export(scene, 0.5), HasSubstr("light_source { <6, 2, 3> "));
}

TEST(PovExportTest, WritesBackgrounds) {
  Scene scene = LargeScene();
  scene.background.kind = ConstantBackground{Rgb(0.1f, 0.2f, 0.3f)};
  EXPECT_THAT(Export(scene), HasSubstr("background { rgb <0.1, 0.2, 0.3> }\n"));
  scene.background.kind = GradientBackground{Rgb(1), Rgb(0.5f)};
  EXPECT_THAT(Export(scene),
              HasSubstr("function { 0.25 * (y + 2) } color_map { [0.25 rgb <1, "
                        "1, 1>] [0.75 rgb <0.5, 0.5, 0.5>] }"));
}

TEST(PovExportTest, AcceptsGlassThatOnlyTouchesInItsBoundingBoxes) {
  // Boxes of the spheres overlap, the spheres (distance sqrt(12) * 0.7 = 2.42)
  // do not.
  Scene scene = MakeScene();
  const Index glass = AddMaterial(&scene, Dielectric{});
  AddObject(&scene, Sphere{V3d(0, 0, -9), 1}, glass);
  AddObject(&scene, Sphere{V3d(1.4, 1.4, -7.6), 1}, glass);
  AddObject(&scene, Box{V3d(-5, -5, -9), V3d(-4, -4, -8)}, glass);
  EXPECT_TRUE(ExportPov(scene, 0).has_value());
}

TEST(PovExportTest, AMaterialThatNothingUsesIsNoObstacle) {
  Scene scene = LargeScene();
  AddMaterial(&scene, Plastic{});
  EXPECT_TRUE(ExportPov(scene, 0).has_value());
}

}  // namespace
}  // namespace rtb
