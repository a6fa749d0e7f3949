#include <gtest/gtest.h>

#include "core/scene/flat_scene.h"

namespace rtb {
namespace {

Object Shape(decltype(Object::shape) shape) {
  Object object;
  object.shape = std::move(shape);
  return object;
}

FlatScene Flat(const Scene& scene, double time = 0) {
  Result<FlatScene> flat = Flatten(scene, time);
  EXPECT_TRUE(flat.has_value());
  return flat.has_value() ? *flat : FlatScene{};
}

TEST(FlattenTest, ComposesGroupsFromTheOutsideIn) {
  // Inner: x -> 2x then +1 along x; outer: quarter turn about z, then +(0,0,5).
  // The sphere's center (1, 0, 0) becomes (3, 0, 0), then (0, 3, 5).
  Object sphere = Shape(Sphere{V3d(1, 0, 0), 0.5});
  sphere.scale = V3d(2, 2, 2);
  sphere.position = V3d(1, 0, 0);
  Object group = Shape(Group{});
  group.rotate = V3d(0, 0, 90);
  group.position = V3d(0, 0, 5);
  group.children = {sphere};
  Scene scene;
  scene.objects = {group};
  const FlatScene flat = Flat(scene);
  ASSERT_EQ(flat.spheres.size(), 1u);
  const Affined& map = flat.spheres[0].unit_to_world;
  EXPECT_EQ(map.origin, V3d(0, 3, 5));
  EXPECT_EQ(map.x, V3d(0, 1, 0));  // radius 0.5 times scale 2, turned
}

TEST(FlattenTest, MaterialIsItsOwnElseTheNearestAncestors) {
  Object own = Shape(Sphere{});
  own.material = 2;
  Object heir = Shape(Sphere{});
  Object inner = Shape(Group{});
  inner.children = {own, heir};
  Object outer = Shape(Group{});
  outer.material = 1;
  outer.children = {inner};
  Scene scene;
  scene.objects = {outer, Shape(Sphere{})};
  const FlatScene flat = Flat(scene);
  ASSERT_EQ(flat.objects.size(), 3u);
  EXPECT_EQ(flat.objects[0].material, 2);
  EXPECT_EQ(flat.objects[1].material, 1);
  EXPECT_EQ(flat.objects[2].material, kNone);
}

TEST(FlattenTest, InstanceStandsWithItsOwnTransformAndMaterial) {
  Object group = Shape(Group{});
  group.id = "table";
  group.material = 0;
  group.position = V3d(100, 0, 0);
  group.children = {Shape(Sphere{})};
  Object instance = Shape(Instance{"table"});
  instance.position = V3d(0, 7, 0);
  Object painted = instance;
  painted.material = 3;
  Scene scene;
  scene.objects = {group, instance, painted};
  const FlatScene flat = Flat(scene);
  ASSERT_EQ(flat.spheres.size(), 3u);
  EXPECT_EQ(flat.spheres[0].unit_to_world.origin, V3d(100, 0, 0));
  EXPECT_EQ(flat.spheres[1].unit_to_world.origin, V3d(0, 7, 0));
  EXPECT_EQ(flat.objects[1].material, 0);
  EXPECT_EQ(flat.objects[2].material, 3);
}

TEST(FlattenTest, BoxIsTwelveTrianglesFacingOutwards) {
  Scene scene;
  scene.objects = {Shape(Box{V3d(1, 2, 3), V3d(2, 4, 6)})};
  const FlatScene flat = Flat(scene);
  ASSERT_EQ(flat.triangles.size(), 12u);
  const V3f center(1.5f, 3, 4.5f);
  float area = 0;
  for (const FlatTriangle& t : flat.triangles) {
    const auto& v = t.vertices;
    const V3f normal = (v[1] - v[0]).cross(v[2] - v[0]);
    EXPECT_GT(normal.dot(v[0] - center), 0);
    area += normal.length() / 2;
  }
  EXPECT_FLOAT_EQ(area, 2 * (1 * 2 + 2 * 3 + 1 * 3));
}

TEST(FlattenTest, PolygonIsAFanFromVertexZero) {
  Scene scene;
  scene.objects = {Shape(Polygon{
      {V3d(0, 0, 0), V3d(1, 0, 0), V3d(2, 1, 0), V3d(1, 2, 0), V3d(0, 1, 0)}})};
  const FlatScene flat = Flat(scene);
  ASSERT_EQ(flat.triangles.size(), 3u);
  EXPECT_EQ(flat.triangles[2].vertices[0], V3f(0, 0, 0));
  EXPECT_EQ(flat.triangles[2].vertices[1], V3f(1, 2, 0));
  EXPECT_EQ(flat.triangles[2].vertices[2], V3f(0, 1, 0));
}

TEST(FlattenTest, PlaneNormalGoesByTheInverseTranspose) {
  // The plane x + y = 0 under scale (1, 2, 1): y/2 + x = 0, normal (2, 1, 0).
  Object plane = Shape(Plane{V3d(0, 0, 0), V3d(1, 1, 0)});
  plane.scale = V3d(1, 2, 1);
  Scene scene;
  scene.objects = {plane};
  const V3d n = Flat(scene).planes.at(0).normal;
  EXPECT_NEAR(n.x, 2 / std::sqrt(5.0), 1e-15);
  EXPECT_NEAR(n.y, 1 / std::sqrt(5.0), 1e-15);
}

TEST(FlattenTest, PathMovesItsOwner) {
  Object sphere = Shape(Sphere{});
  sphere.position = V3d(1, 0, 0);
  sphere.path = 0;
  Scene scene;
  scene.paths = {{"p",
                  {V3d(0, 0, 0), V3d(4, 0, 0)},
                  {0, 2},
                  2,
                  false,
                  Path::Interpolation::kLinear}};
  scene.objects = {sphere};
  EXPECT_EQ(Flat(scene, 0.5).spheres.at(0).unit_to_world.origin, V3d(2, 0, 0));
}

TEST(FlattenTest, LeavingSinglePrecisionIsAnErrorThatNamesTheObject) {
  Object far = Shape(Sphere{V3d(1e60, 0, 0), 1});
  far.mark = {12, 5};
  Scene scene;
  scene.file = "far.yaml";
  scene.objects = {far};
  const Result<FlatScene> flat = Flatten(scene, 0);
  ASSERT_FALSE(flat.has_value());
  EXPECT_EQ(flat.error().kind, ErrorKind::kBadInput);
  EXPECT_EQ(flat.error().place, "far.yaml:12:5");
}

TEST(FlattenTest, TooManyExpandedTrianglesAreAnErrorNotACrash) {
  // One mesh of more than the most, all triangles degenerate, so that only
  // the count is at stake.
  Scene scene;
  scene.meshes.resize(1);
  scene.meshes[0].positions = {V3f(0), V3f(0), V3f(0)};
  scene.meshes[0].triangles.assign((std::size_t{1} << 26) + 1, {0, 0, 0});
  scene.objects = {Shape(Mesh{"m.obj", false, 0, 0})};
  FlatScene flat = Flat(scene);
  ASSERT_EQ(flat.meshes.size(), 1u);
  const Status expanded = ExpandMeshes(scene, &flat);
  ASSERT_FALSE(expanded.has_value());
  EXPECT_NE(expanded.error().what.find("triangles"), std::string::npos);
}

TEST(FlattenTest, ScaleUnderflowIsAnError) {
  Object inner = Shape(Sphere{});
  inner.scale = V3d(1e-200, 1, 1);
  Object outer = Shape(Group{});
  outer.scale = V3d(1e-200, 1, 1);
  outer.children = {inner};
  Scene scene;
  scene.objects = {outer};
  EXPECT_FALSE(Flatten(scene, 0).has_value());
}

}  // namespace
}  // namespace rtb
