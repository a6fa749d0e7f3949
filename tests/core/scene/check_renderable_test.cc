#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <ostream>
#include <string>

#include "core/scene/load.h"
#include "tests/core/scene/scene_text.h"

namespace rtb {
namespace {

const std::filesystem::path kData = RTB_TEST_SOURCE_DIR "/tests/data/scenes";

Status Check(const std::string& sections) {
  const auto scene = ParseScene(kPreamble + sections, kData / "s.yaml");
  if (!scene) return Fail(scene.error());
  return CheckRenderable(*scene);
}

TEST(CheckRenderableTest, WhatIsRendered) {
  const Status status = Check(
      "background: {type: gradient, bottom: [1, 1, 1], top: [0, 0, 1]}\n"
      "settings: {ambient: [1, 1, 1], exposure: 1, max_depth: 0}\n"
      "materials:\n"
      "  - {id: a, type: lambertian, albedo: [1, 1, 1]}\n"
      "  - {id: b, type: metal, texture: {type: checker, a: [0, 0, 0],\n"
      "     b: [1, 1, 1], size: 1}}\n"
      "  - {id: c, type: mirror}\n"
      "  - {id: d, type: dielectric, ior: 1.5}\n"
      "  - {id: e, type: emissive, radiance: [1, 1, 1]}\n"
      "lights:\n"
      "  - {type: point, position: [0, 0, 0], intensity: [1, 1, 1],\n"
      "     path: p}\n"
      "  - {type: directional, direction: [0, 0, 1],\n"
      "     irradiance: [1, 1, 1]}\n"
      "objects:\n"
      "  - {type: mesh, id: m, file: quad.obj}\n"
      "  - {type: mesh, file: smooth.obj, smooth: false}\n"
      "  - {type: instance, of: m, path: p}\n"
      "  - {type: plane, point: [0, 0, 0], normal: [0, 1, 0]}\n"
      "paths: [{id: p, points: [[0, 0, 0], [1, 0, 0]], duration: 1,\n"
      "  interpolation: catmull_rom}]\n");
  EXPECT_TRUE(status) << status.error().ToString();
}

struct Unrendered {
  std::string name;
  std::string text;
  int line;
  std::string message;
};

void PrintTo(const Unrendered& row, std::ostream* out) { *out << row.name; }

class UnrenderedTest : public testing::TestWithParam<Unrendered> {};

TEST_P(UnrenderedTest, IsNamedWithItsLine) {
  const Status status = Check(GetParam().text);
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().kind, ErrorKind::kBadInput);
  const std::string line = "s.yaml:" + std::to_string(GetParam().line) + ":";
  EXPECT_THAT(status.error().place, testing::HasSubstr(line));
  EXPECT_THAT(status.error().what, testing::HasSubstr(GetParam().message));
  EXPECT_THAT(status.error().what, testing::EndsWith("is not rendered yet"));
}

const Unrendered kRows[] = {
    {"ImageBackground", "background: {type: image, file: quad.obj}\n", 4,
     "background"},
    {"RoughMetal",
     "materials:\n  - {id: a, type: metal, albedo: [1, 1, 1],\n"
     "     roughness: 0.1}\n",
     5, "`roughness`"},
    {"Plastic",
     "materials:\n  - {id: a, type: plastic, albedo: [1, 1, 1], ior: 1}\n", 5,
     "plastic"},
    {"Phong",
     "materials:\n  - {id: a, type: phong, albedo: [1, 1, 1],\n"
     "     specular: [1, 1, 1], exponent: 1}\n",
     5, "phong"},
    {"ImageTexture",
     "materials:\n  - {id: a, type: lambertian,\n"
     "     texture: {type: image, file: quad.obj}}\n",
     5, "texture"},
    {"Bump",
     "materials:\n  - {id: a, type: mirror,\n"
     "     bump: {file: quad.obj, amount: 1}}\n",
     5, "`bump`"},
    {"Spot",
     "lights:\n  - {type: spot, position: [0, 0, 0], direction: [0, 0, 1],\n"
     "     intensity: [1, 1, 1], cone: 1}\n",
     5, "spot"},
    {"QuadLight",
     "lights:\n  - {type: quad, corner: [0, 0, 0],\n"
     "     edges: [[1, 0, 0], [0, 1, 0]], radiance: [1, 1, 1]}\n",
     5, "quad"},
    {"SphereLight",
     "lights:\n  - {type: sphere, center: [0, 0, 0], radius: 1,\n"
     "     radiance: [1, 1, 1]}\n",
     5, "sphere"},
    {"Subdivide",
     "objects:\n  - type: group\n    children:\n"
     "      - {type: mesh, file: quad.obj, subdivide: 1}\n",
     7, "`subdivide`"},
    {"SmoothWithNormals", "objects:\n  - {type: mesh, file: smooth.obj}\n", 5,
     "`smooth`"},
};

INSTANTIATE_TEST_SUITE_P(Table, UnrenderedTest, testing::ValuesIn(kRows),
                         [](const auto& row) { return row.param.name; });

}  // namespace
}  // namespace rtb
