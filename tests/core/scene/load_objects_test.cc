// The values of every key of objects read back.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "core/scene/load.h"
#include "tests/core/scene/scene_text.h"

namespace rtb {
namespace {

const std::filesystem::path kData = RTB_TEST_SOURCE_DIR "/tests/data/scenes";

Scene Parsed(const std::string& sections) {
  const auto scene = ParseScene(kPreamble + sections, kData / "scene.yaml");
  if (!scene) {
    ADD_FAILURE() << scene.error().ToString();
    return {};
  }
  return *scene;
}

/// The shape of the one object that `keys` describe.
template <class Shape>
Shape ParsedShape(const std::string& keys) {
  const Scene scene = Parsed("objects:\n  - {" + keys + "}\n");
  if (scene.objects.empty()) return {};
  return std::get<Shape>(scene.objects[0].shape);
}

TEST(LoadObjectsTest, RoundShapes) {
  const auto sphere =
      ParsedShape<Sphere>("type: sphere, center: [1, 2, 3], radius: 4");
  EXPECT_EQ(sphere.center, V3d(1, 2, 3));
  EXPECT_EQ(sphere.radius, 4);
  const auto plane =
      ParsedShape<Plane>("type: plane, point: [0, 1, 0], normal: [0, 2, 0]");
  EXPECT_EQ(plane.point, V3d(0, 1, 0));
  EXPECT_EQ(plane.normal, V3d(0, 2, 0));
  const auto disk = ParsedShape<Disk>(
      "type: disk, center: [0, 1, 0], normal: [1, 0, 0], radius: 0.5");
  EXPECT_EQ(disk.center, V3d(0, 1, 0));
  EXPECT_EQ(disk.normal, V3d(1, 0, 0));
  EXPECT_EQ(disk.radius, 0.5);
}

TEST(LoadObjectsTest, FlatShapes) {
  const auto triangle = ParsedShape<Triangle>(
      "type: triangle, vertices: [[0, 0, 0], [1, 0, 0], [0, 1, 0]]");
  EXPECT_EQ(triangle.vertices[2], V3d(0, 1, 0));
  const auto quad = ParsedShape<Quad>(
      "type: quad, corner: [1, 1, 1], edges: [[1, 0, 0], [1, 1, 0]]");
  EXPECT_EQ(quad.corner, V3d(1, 1, 1));
  EXPECT_EQ(quad.edges[1], V3d(1, 1, 0));
  const auto box =
      ParsedShape<Box>("type: box, min: [-1, -2, -3], max: [1, 2, 3]");
  EXPECT_EQ(box.min, V3d(-1, -2, -3));
  EXPECT_EQ(box.max, V3d(1, 2, 3));
}

TEST(LoadObjectsTest, PolygonsMayBeALittleOffPlane) {
  // The published Cornell box's red wall is not quite planar.
  const auto wall = ParsedShape<Polygon>(
      "type: polygon, vertices: [[552.8, 0, 0], [549.6, 0, 559.2],\n"
      "     [556, 548.8, 559.2], [556, 548.8, 0]]");
  EXPECT_EQ(wall.vertices.size(), 4u);
  EXPECT_EQ(wall.vertices[1], V3d(549.6, 0, 559.2));
}

TEST(LoadObjectsTest, PolygonsMayTurnEitherWayAndHaveStraightCorners) {
  EXPECT_EQ(ParsedShape<Polygon>("type: polygon, vertices: [[0, 0, 0], "
                                 "[0, 1, 0], [1, 1, 0], [1, 0, 0]]")
                .vertices.size(),
            4u);
  EXPECT_EQ(ParsedShape<Polygon>("type: polygon, vertices: [[0, 0, 0], "
                                 "[1, 0, 0], [2, 0, 0], [0, 2, 0]]")
                .vertices.size(),
            4u);
}

TEST(LoadObjectsTest, TransformsMaterialsAndPaths) {
  const Scene scene = Parsed(
      "objects:\n"
      "  - {id: s, type: sphere, center: [0, 0, 0], radius: 1,\n"
      "     position: [1, 2, 3], rotate: [10, 20, 30], scale: [1, 2, 3],\n"
      "     material: red, path: slide}\n"
      "  - {type: sphere, center: [0, 0, 0], radius: 1, scale: 2}\n"
      "materials: [{id: white, type: mirror}, {id: red, type: mirror}]\n"
      "paths: [{id: slide, points: [[0, 0, 0]], duration: 1}]\n");
  ASSERT_EQ(scene.objects.size(), 2u);
  const Object& first = scene.objects[0];
  EXPECT_EQ(first.id, "s");
  EXPECT_EQ(first.position, V3d(1, 2, 3));
  EXPECT_EQ(first.rotate, V3d(10, 20, 30));
  EXPECT_EQ(first.scale, V3d(1, 2, 3));
  EXPECT_EQ(first.material, 1);
  EXPECT_EQ(first.path, 0);
  EXPECT_EQ(first.mark.line, 5);
  EXPECT_EQ(first.mark.column, 5);
  const Object& second = scene.objects[1];
  EXPECT_EQ(second.position, V3d(0, 0, 0));
  EXPECT_EQ(second.scale, V3d(2, 2, 2));
  EXPECT_EQ(second.material, kNone);
  EXPECT_EQ(second.path, kNone);
}

TEST(LoadObjectsTest, GroupsInstancesAndFindObject) {
  const Scene scene = Parsed(
      "objects:\n"
      "  - {type: instance, of: inner, position: [1, 0, 0]}\n"
      "  - type: group\n"
      "    id: outer\n"
      "    children:\n"
      "      - type: group\n"
      "        id: inner\n"
      "        children:\n"
      "          - {type: box, id: leaf, min: [0, 0, 0], max: [1, 1, 1]}\n"
      "      - {type: instance, of: inner}\n");
  ASSERT_EQ(scene.objects.size(), 2u);
  const auto& instance = std::get<Instance>(scene.objects[0].shape);
  EXPECT_EQ(instance.of, "inner");
  EXPECT_EQ(instance.of_mark.line, 5);
  EXPECT_EQ(instance.of_mark.column, 26);
  const Object* outer = FindObject(scene, "outer");
  ASSERT_EQ(outer, &scene.objects[1]);
  EXPECT_EQ(FindObject(scene, "inner"), &outer->children[0]);
  EXPECT_EQ(FindObject(scene, "leaf"), &outer->children[0].children[0]);
  EXPECT_EQ(FindObject(scene, "nobody"), nullptr);
  EXPECT_EQ(FindObject(scene, ""), nullptr);
  EXPECT_EQ(scene.object_places.size(), 3u);
  // Without the index, or with one that the tree has outgrown, as well.
  Scene changed = scene;
  changed.objects.erase(changed.objects.begin());
  EXPECT_EQ(FindObject(changed, "outer"), &changed.objects[0]);
  changed.object_places.clear();
  EXPECT_EQ(FindObject(changed, "leaf"),
            &changed.objects[0].children[0].children[0]);
}

}  // namespace
}  // namespace rtb
