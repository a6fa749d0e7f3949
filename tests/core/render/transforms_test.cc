// A scene composed of groups, instances and scales equals the same scene
// written with every vertex where it ends up.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/render/measure.h"
#include "tests/core/scene/mesh_shapes.h"

namespace rtb {
namespace {

using testing::By;
using testing::CountLit;
using testing::CountOff;
using testing::SceneBuilder;

/// p -> position + Rz Ry Rx (scale * p), written out here once more.
struct Trs {
  V3d position{0};
  V3d rotate{0};
  V3d scale{1, 1, 1};

  V3d Turned(V3d p) const {
    for (int axis = 0; axis < 3; ++axis) {
      const double a = rotate[axis] * testing::kPiExact / 180;
      const int i = (axis + 1) % 3, j = (axis + 2) % 3;
      const double pi = p[i], pj = p[j];
      p[i] = std::cos(a) * pi - std::sin(a) * pj;
      p[j] = std::sin(a) * pi + std::cos(a) * pj;
    }
    return p;
  }
  V3d Point(const V3d& p) const { return position + Turned(scale * p); }
  /// Normals go by the inverse transpose. Their lengths are kept: what is
  /// interpolated in an object's own coordinates and then placed is the same
  /// combination of these, not of unit vectors.
  V3d Normal(const V3d& n) const { return Turned(n / scale); }
  void Place(Object* object) const {
    object->position = position;
    object->rotate = rotate;
    object->scale = scale;
  }
};

constexpr auto kOuter = [] {
  return Trs{V3d(0.4, 0.1, -0.5), V3d(20, -35, 10), V3d(1.3, 0.8, 1.1)};
};
constexpr auto kInner = [] {
  return Trs{V3d(-0.9, 0.3, 0.2), V3d(-15, 50, 70), V3d(0.7, 1.2, 0.9)};
};
constexpr auto kOwn = [] {
  return Trs{V3d(0.2, 0.5, 0.3), V3d(5, 15, -25), V3d(0.5, 0.9, 0.6)};
};

/// Chains of transforms, the outermost first.
using Chain = std::vector<Trs>;

V3d PointBy(const Chain& chain, V3d p) {
  for (auto t = chain.rbegin(); t != chain.rend(); ++t) p = t->Point(p);
  return p;
}

TriangleMesh Flat(const TriangleMesh& mesh, const Chain& chain) {
  TriangleMesh flat = mesh;
  for (V3f& p : flat.positions) p = V3f(PointBy(chain, V3d(p)));
  for (V3f& n : flat.normals) {
    V3d normal(n);
    for (auto t = chain.rbegin(); t != chain.rend(); ++t) {
      normal = t->Normal(normal);
    }
    n = V3f(normal);
  }
  return flat;
}

Object Group(const Trs& trs, std::vector<Object> children) {
  Object group;
  group.shape = rtb::Group{};
  trs.Place(&group);
  group.children = std::move(children);
  return group;
}

Object Of(decltype(Object::shape) shape, Index material) {
  Object object;
  object.shape = std::move(shape);
  object.material = material;
  return object;
}

/// Camera, lights, materials 0 (clay) and 1 (mirror), a floor; mesh 0.
SceneBuilder Stage(TriangleMesh mesh) {
  SceneBuilder b;
  const Index clay = b.Add(Lambertian{Rgb(0.7f, 0.5f, 0.3f)});
  b.Add(Mirror{Rgb(0.8f)});
  b.Add(Plane{V3d(0, -1.5, 0), V3d(0, 1, 0)}, clay);
  b.scene.meshes.push_back(std::move(mesh));
  b.AddLight(PointLight{V3d(3, 4, 2), Rgb(30), true});
  b.AddLight(DirectionalLight{V3d(1, -2, -1), Rgb(0.7f)});
  b.scene.background.kind = GradientBackground{Rgb(0.1f), Rgb(0.5f, 0.6f, 1)};
  b.scene.camera.vfov = 40;
  b.Look(V3d(0.5, 1, 6), V3d(0, 0, 0));
  return b;
}

/// Equal but for rays along edges.
void ExpectEqual(const SceneBuilder& a, const SceneBuilder& b) {
  const SamplePlan plan = PixelPlan(72, 48);
  const Fragments fa = a.Render(plan, By("whitted", 3));
  const Fragments fb = b.Render(plan, By("whitted", 3));
  EXPECT_LE(CountOff(fa, fb, 2e-5f), 35);  // 1 %
  EXPECT_LE(CountOff(fa, fb, 1e-3f), 12);
  EXPECT_GT(CountLit(fa), 1000);
}

TEST(TransformsTest, NestedGroupsOfASmoothMesh) {
  SceneBuilder tree = Stage(SmoothIcosphere(2));
  for (const Index material : {0, 1}) {
    Object mesh = Of(Mesh{"", true, 0, 0}, material);
    kOwn().Place(&mesh);
    mesh.position.x += 1.5 * material;
    SceneBuilder a = tree;
    a.scene.objects.push_back(Group(kOuter(), {Group(kInner(), {mesh})}));
    Trs own = kOwn();
    own.position.x += 1.5 * material;
    SceneBuilder b = Stage(Flat(SmoothIcosphere(2), {kOuter(), kInner(), own}));
    b.scene.objects.push_back(Of(Mesh{"", true, 0, 0}, material));
    ExpectEqual(a, b);
  }
}

TEST(TransformsTest, InstancesOfGroupsAndMeshes) {
  // The original stands to the left under another transform; an instance's own
  // transform and material stand in place of its.
  SceneBuilder a = Stage(SmoothIcosphere(1));
  Object gem = Of(Mesh{"", true, 0, 0}, kNone);
  gem.id = "gem";
  gem.material = 0;
  kInner().Place(&gem);
  Object group = Group({V3d(-1.2, 0, 0), V3d(0, 20, 0), V3d(0.6)}, {gem});
  group.id = "group";
  a.scene.objects.push_back(group);
  Object copy = Of(Instance{"group"}, kNone);
  kOuter().Place(&copy);
  copy.position.x += 1.2;
  Object bare = Of(Instance{"gem"}, 1);
  const Trs last{V3d(0, 1.4, -1), V3d(0, 0, 30), V3d(0.5, 0.4, 0.5)};
  last.Place(&bare);
  a.scene.objects.push_back(copy);
  a.scene.objects.push_back(bare);

  SceneBuilder b =
      Stage(Flat(SmoothIcosphere(1),
                 {Trs{V3d(-1.2, 0, 0), V3d(0, 20, 0), V3d(0.6)}, kInner()}));
  b.scene.objects.push_back(Of(Mesh{"", true, 0, 0}, 0));
  Trs moved = kOuter();
  moved.position.x += 1.2;
  b.Add(Flat(SmoothIcosphere(1), {moved, kInner()}), 0);
  b.Add(Flat(SmoothIcosphere(1), {last}), 1);
  ExpectEqual(a, b);
}

TEST(TransformsTest, FlatShapesUnderNonUniformScales) {
  const Chain chain = {kOuter(), kInner(), kOwn()};
  const auto place = [&](const V3d& p) { return PointBy(chain, p); };
  const V3d box_min(-1, -0.5, -0.7), box_max(0.8, 0.9, 1);
  SceneBuilder a = Stage(Tetrahedron());
  Object box = Of(Box{box_min, box_max}, 0);
  Object triangle =
      Of(Triangle{{V3d(2, 0, 0), V3d(3, 0, 0.5), V3d(2, 1.5, 1)}}, 1);
  for (Object* object : {&box, &triangle}) kOwn().Place(object);
  a.scene.objects.push_back(
      Group(kOuter(), {Group(kInner(), {box, triangle})}));
  SceneBuilder b = Stage(Tetrahedron());
  // The faces of the box as quads with edges, outward.
  const V3d size = box_max - box_min;
  for (int axis = 0; axis < 3; ++axis) {
    V3d e0(0), e1(0), across(0);
    e0[(axis + 1) % 3] = size[(axis + 1) % 3];
    e1[(axis + 2) % 3] = size[(axis + 2) % 3];
    across[axis] = size[axis];
    for (const auto& [corner, u, v] :
         {std::tuple(box_min, e1, e0), std::tuple(box_min + across, e0, e1)}) {
      const V3d c = place(corner);
      b.Add(Quad{c, {place(corner + u) - c, place(corner + v) - c}}, 0);
    }
  }
  b.Add(Triangle{{place(V3d(2, 0, 0)), place(V3d(3, 0, 0.5)),
                  place(V3d(2, 1.5, 1))}},
        1);
  ExpectEqual(a, b);
}

TEST(TransformsTest, RoundShapesUnderUniformScales) {
  // Uniform scales s: a sphere's center is placed, its radius times s; a
  // disk's normal is turned.
  const Trs outer{V3d(0.3, -0.2, 0.1), V3d(10, 20, 30), V3d(1.2)};
  const Trs own{V3d(-0.4, 0.5, 0.2), V3d(-40, 15, 5), V3d(0.8)};
  SceneBuilder a = Stage(Tetrahedron());
  Object ball = Of(Sphere{V3d(0.5, 0.2, 0), 0.9}, 0);
  Object disk = Of(Disk{V3d(-1.2, 0, 0), V3d(0.3, 0.4, 1), 0.7}, 1);
  own.Place(&ball);
  own.Place(&disk);
  a.scene.objects.push_back(Group(outer, {ball, disk}));
  SceneBuilder b = Stage(Tetrahedron());
  const Chain chain = {outer, own};
  b.Add(Sphere{PointBy(chain, V3d(0.5, 0.2, 0)), 0.9 * 1.2 * 0.8}, 0);
  b.Add(Disk{PointBy(chain, V3d(-1.2, 0, 0)),
             outer.Turned(own.Turned(V3d(0.3, 0.4, 1))), 0.7 * 1.2 * 0.8},
        1);
  ExpectEqual(a, b);
}

}  // namespace
}  // namespace rtb
