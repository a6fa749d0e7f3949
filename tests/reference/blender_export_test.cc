#include "reference/blender_export.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "reference/blender_geometry.h"
#include "tests/reference/scene_maker.h"

namespace rtb {
namespace {

using testing::HasSubstr;

nlohmann::json Exported(const Scene& scene, double time = 0,
                        const std::string& integrator = "path") {
  const auto text = ExportBlender(scene, time, integrator);
  EXPECT_TRUE(text.has_value()) << text.error().ToString();
  return nlohmann::json::parse(text.value_or("{}"));
}

/// The place in the file, `2:4` of MakeScene's materials, and the words.
void ExpectRefusal(const Scene& scene, const std::string& words,
                   const std::string& integrator = "path") {
  const auto text = ExportBlender(scene, 0, integrator);
  ASSERT_FALSE(text.has_value()) << words;
  EXPECT_EQ(text.error().kind, ErrorKind::kBadInput);
  EXPECT_EQ(text.error().place, "made.yaml:7:3");
  EXPECT_THAT(text.error().what, HasSubstr(words));
}

TEST(BlenderExportTest, SpheresAreTheUnitSphereUnderAMatrix) {
  Scene scene = MakeScene();
  Object& object = AddObject(&scene, Sphere{V3d(1, 2, 3), 0.5});
  object.scale = V3d(2, 2, 4);
  object.position = V3d(10, 0, 0);
  const auto json = Exported(scene);
  const auto& sphere = json["objects"][0];
  // Radius 0.5 under the scale; the center (1, 2, 3) goes to (12, 4, 12).
  EXPECT_EQ(sphere["matrix"],
            nlohmann::json({1, 0, 0, 0, 1, 0, 0, 0, 2, 12, 4, 12}));
  EXPECT_EQ(sphere["sphere"], nlohmann::json({1, 2, 3, 0.5}));
  // No material was named: the default one, after the scene's none.
  EXPECT_EQ(sphere["material"], 0);
  EXPECT_EQ(json["materials"][0]["color"], nlohmann::json({0.5, 0.5, 0.5}));
}

TEST(BlenderExportTest, AMeshStandsOnceHoweverOftenItIsUsed) {
  Scene scene = MakeScene();
  TriangleMesh mesh;
  mesh.positions = {V3f(0, 0, 0), V3f(1, 0, 0), V3f(0, 1, 0)};
  mesh.triangles = {{0, 1, 2}};
  scene.meshes.push_back(mesh);
  Mesh use;
  use.data = 0;
  AddObject(&scene, use).position = V3d(1, 0, 0);
  AddObject(&scene, use).position = V3d(2, 0, 0);
  const auto json = Exported(scene);
  ASSERT_EQ(json["meshes"].size(), 1u);
  // Base64 of nine floats: 0 0 0, 1 0 0, 0 1 0; 1 is 00 00 80 3f in memory.
  EXPECT_EQ(json["meshes"][0]["positions"],
            "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA");
  EXPECT_EQ(json["meshes"][0]["triangles"], "AAAAAAEAAAACAAAA");
  EXPECT_EQ(json["objects"][0]["mesh"], 0);
  EXPECT_EQ(json["objects"][1]["mesh"], 0);
  EXPECT_EQ(json["objects"][1]["matrix"][9], 2);
}

TEST(BlenderExportTest, WorldsWithLargeLightsShrink) {
  Scene scene = MakeScene();
  scene.camera.position = V3d(16, 0, 0);
  // Triangles of twice the area 4: 4 s^2 <= 1/64 for s = 1/16.
  AddLight(&scene,
           QuadLight{V3d(0, 0, 0), {V3d(2, 0, 0), V3d(0, 2, 0)}, Rgb(1), 1});
  AddLight(&scene, PointLight{V3d(32, 0, 0), Rgb(256), true});
  AddLight(&scene, PointLight{V3d(32, 0, 0), Rgb(256), false});
  const auto json = Exported(scene);
  EXPECT_EQ(json["scale"], 1.0 / 16);
  EXPECT_EQ(json["camera"]["position"], nlohmann::json({1, 0, 0}));
  EXPECT_EQ(json["lamps"][0]["position"], nlohmann::json({2, 0, 0}));
  // Irradiance is intensity / distance^2, without falloff intensity alone.
  EXPECT_EQ(json["lamps"][0]["intensity"][0], 1);
  EXPECT_EQ(json["lamps"][1]["intensity"][0], 256);
  EXPECT_EQ(json["objects"][0]["matrix"][0], 1.0 / 16);
  // The scene has no material: index 0 is the default, 1 the first light's.
  EXPECT_EQ(json["objects"][0]["material"], 1);
  EXPECT_EQ(json["materials"][1]["type"], "light");
}

TEST(BlenderExportTest, AmbientLightIsTheWhittedIntegratorsAlone) {
  Scene scene = MakeScene();
  scene.settings.ambient = Rgb(0.5f);
  EXPECT_EQ(Exported(scene)["ambient"], nlohmann::json({0, 0, 0}));
  EXPECT_EQ(Exported(scene, 0, "whitted")["ambient"],
            nlohmann::json({0.5, 0.5, 0.5}));
}

TEST(BlenderExportTest, RefusesWhatCyclesHasNot) {
  Scene scene = MakeScene();
  AddObject(&scene, Sphere{}, AddMaterial(&scene, Plastic{}));
  ExpectRefusal(scene, "`type: plastic`");
  scene.materials[0].bsdf = Phong{};
  ExpectRefusal(scene, "`type: phong`");
  scene.materials[0].bsdf = Dielectric{};
  scene.materials[0].texture = CheckerTexture{};
  ExpectRefusal(scene, "`texture` on a dielectric");
  scene.materials[0].texture = {};
  scene.materials[0].bsdf = Metal{Rgb(0.5f), 0.3};
  ExpectRefusal(scene, "`roughness` of a metal", "whitted");
  EXPECT_TRUE(ExportBlender(scene, 0).has_value());
}

TEST(BlenderExportTest, UnusedMaterialsAreNotRefused) {
  Scene scene = MakeScene();
  AddMaterial(&scene, Phong{});
  EXPECT_TRUE(Exported(scene)["materials"][0].is_null());
}

double AreaOf(const BlenderMesh& mesh) {
  double area = 0;
  for (const auto& corners : mesh.triangles) {
    const auto at = [&](std::size_t i) {
      return V3d(mesh.positions[static_cast<std::size_t>(corners[i])]);
    };
    area += (at(1) - at(0)).cross(at(2) - at(0)).length() / 2;
  }
  return area;
}

TEST(BlenderGeometryTest, ADiskHasTheAreaOfItsPolygon) {
  Scene scene = MakeScene();
  AddObject(&scene, Disk{V3d(1, 2, 3), V3d(0, 3, 4), 2});
  const auto flat = Flatten(scene, 0);
  ASSERT_TRUE(flat.has_value());
  const BlenderMesh mesh = BlenderDisk(*flat, flat->disks[0]);
  EXPECT_NEAR(AreaOf(mesh), 4 * 3.14159265, 1e-5);
  // In the plane, texture coordinates in units of the scene.
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const V3d d = V3d(mesh.positions[i]) - V3d(1, 2, 3);
    EXPECT_NEAR(d.dot(V3d(0, 0.6, 0.8)), 0, 1e-6);
    EXPECT_NEAR(V2d(mesh.uvs[i]).length(), d.length(), 1e-6);
  }
}

TEST(BlenderGeometryTest, APlaneIsASquareWithoutGaps) {
  Scene scene = MakeScene();
  AddObject(&scene, Plane{V3d(0, -1, 0), V3d(0, 1, 0)}).scale = V3d(1, 2, 1);
  const auto flat = Flatten(scene, 0);
  ASSERT_TRUE(flat.has_value());
  const V3d camera(5, 0, 0);  // 2 over the plane, which the scale moves to -2
  const BlenderMesh mesh = BlenderPlane(*flat, flat->planes[0], camera, 4);
  // No gaps, no overlaps: the areas of all triangles are that of the square.
  const double half = std::abs(mesh.positions.back().x - 5);
  EXPECT_NEAR(AreaOf(mesh) / (4 * half * half), 1, 1e-6);
  EXPECT_GE(half, kPlaneReaches * 4);
  for (const V3f& p : mesh.positions) EXPECT_EQ(p.y, -1);
  // The front of every triangle is above.
  for (const auto& corners : mesh.triangles) {
    const V3f a = mesh.positions[static_cast<std::size_t>(corners[0])];
    const V3f b = mesh.positions[static_cast<std::size_t>(corners[1])];
    const V3f c = mesh.positions[static_cast<std::size_t>(corners[2])];
    EXPECT_GT((b - a).cross(c - a).y, 0);
  }
}

}  // namespace
}  // namespace rtb
