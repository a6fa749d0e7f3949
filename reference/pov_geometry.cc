#include "reference/pov_geometry.h"

#include <cmath>

#include "reference/bounds.h"
#include "reference/pov_material.h"
#include "reference/pov_text.h"

namespace rtb {
namespace {

constexpr double kSmallestExtent = 128;
constexpr double kLargestExtent = 2048;

/// Writes primitives; holds what all of them need.
class GeometryWriter {
 public:
  GeometryWriter(const Scene& scene, const FlatScene& flat, double scale)
      : scene_(scene), flat_(flat), scale_(scale) {}

  std::string operator()(const FlatSphere& sphere) const {
    PatternPlacement placement;
    if (const auto* checker = CheckerOf(MaterialAt(sphere.object))) {
      const Affined to_object = ToObject(sphere.object) * sphere.unit_to_world;
      placement = CheckerOnSphere(checker->size, to_object.origin,
                                  to_object.x.length());
    }
    return "sphere { <0, 0, 0>, 1 " +
           PovMatrix(ScaledBy(sphere.unit_to_world, scale_)) + " " +
           Shading(sphere.object, placement) + " }\n";
  }
  std::string operator()(const FlatDisk& disk) const {
    const Affined to_object = ToObject(disk.object) * disk.unit_to_world;
    return "disc { <0, 0, 0>, <0, 0, 1>, 1 " +
           PovMatrix(ScaledBy(disk.unit_to_world, scale_)) + " " +
           Shading(disk.object,
                   Flat(disk.object, to_object.x.cross(to_object.y))) +
           " }\n";
  }
  std::string operator()(const FlatPlane& plane) const {
    return "plane { " + PovVector(plane.normal) + ", " +
           PovNumber(plane.normal.dot(plane.point) * scale_) + " " +
           Shading(
               plane.object,
               Flat(plane.object, NormalInObject(plane.object, plane.normal))) +
           " }\n";
  }

  std::string Triangles() const {
    std::string text;
    Index object = kNone;
    V3d normal(0);
    for (const FlatTriangle& triangle : flat_.triangles) {
      const V3d own = ObjectNormal(triangle);
      if (triangle.object != object || !SameMesh(object, normal, own)) {
        if (object != kNone) text += MeshEnd(object, normal);
        text += "mesh {\n";
        object = triangle.object;
        normal = own;
      }
      text += Corners(triangle);
    }
    return object == kNone ? text : text + MeshEnd(object, normal);
  }

 private:
  const Material* MaterialAt(Index object) const {
    return MaterialOf(scene_, flat_, object);
  }
  const Affined& ToWorld(Index object) const {
    return flat_.objects[static_cast<std::size_t>(object)].object_to_world;
  }
  Affined ToObject(Index object) const { return ToWorld(object).Inverse(); }

  V3d NormalInObject(Index object, const V3d& world_normal) const {
    return ToWorld(object).Transposed(world_normal);
  }
  V3d ObjectNormal(const FlatTriangle& triangle) const {
    const V3d a(triangle.vertices[0]);
    const V3d normal =
        (V3d(triangle.vertices[1]) - a).cross(V3d(triangle.vertices[2]) - a);
    return NormalInObject(triangle.object, normal.normalized()).normalized();
  }
  /// A mesh has one texture, and a checker's depends on the normal.
  bool SameMesh(Index object, const V3d& a, const V3d& b) const {
    return CheckerOf(MaterialAt(object)) == nullptr || (a - b).length() < 1e-5;
  }

  PatternPlacement Flat(Index object, const V3d& object_normal) const {
    const auto* checker = CheckerOf(MaterialAt(object));
    if (checker == nullptr) return {};
    return CheckerOnFlat(checker->size, object_normal.normalized());
  }
  std::string Shading(Index object, const PatternPlacement& placement) const {
    return PovMaterial(MaterialAt(object), scene_.settings.ambient,
                       ScaledBy(ToWorld(object), scale_), placement);
  }

  std::string Corners(const FlatTriangle& triangle) const {
    const bool smooth = triangle.normals[0] != V3f(0);
    std::string text = smooth ? "  smooth_triangle { " : "  triangle { ";
    for (std::size_t i = 0; i < 3; ++i) {
      if (i > 0) text += ", ";
      text += PovVector(triangle.vertices[i] * static_cast<float>(scale_));
      if (smooth) text += ", " + PovVector(triangle.normals[i]);
    }
    return text + " }\n";
  }
  std::string MeshEnd(Index object, const V3d& object_normal) const {
    // Any direction will do to tell inside from outside; this one is unlikely
    // to run along an edge.
    return "  inside_vector <0.36, 0.48, 0.8>\n  " +
           Shading(object, Flat(object, object_normal)) + "\n}\n";
  }

  const Scene& scene_;
  const FlatScene& flat_;
  const double scale_;
};

}  // namespace

double PovScale(const FlatScene& flat, const V3d& camera) {
  Bounds bounds;
  bounds.Add(camera);
  for (const auto& sphere : flat.spheres) bounds.Add(BoundsOf(sphere));
  for (const auto& disk : flat.disks) bounds.Add(BoundsOf(disk));
  for (const auto& triangle : flat.triangles) bounds.Add(BoundsOf(triangle));
  for (const FlatPlane& plane : flat.planes) {
    const double height = plane.normal.dot(camera - plane.point);
    bounds.Add(camera - plane.normal * height);
  }
  const double extent = bounds.Diagonal();
  if (extent == 0) return 1;
  const auto power = [&](double target) {
    return std::exp2(std::ceil(std::log2(target / extent)));
  };
  if (extent < kSmallestExtent) return power(kSmallestExtent);
  return extent > kLargestExtent ? power(kLargestExtent / 2) : 1;
}

std::string PovGeometry(const Scene& scene, const FlatScene& flat,
                        double scale) {
  const GeometryWriter write(scene, flat, scale);
  std::string text;
  for (const FlatSphere& sphere : flat.spheres) text += write(sphere);
  for (const FlatDisk& disk : flat.disks) text += write(disk);
  for (const FlatPlane& plane : flat.planes) text += write(plane);
  return text + write.Triangles();
}

const Material* MaterialOf(const Scene& scene, const FlatScene& flat,
                           Index object) {
  const Index material =
      flat.objects[static_cast<std::size_t>(object)].material;
  if (material == kNone) return nullptr;
  return &scene.materials[static_cast<std::size_t>(material)];
}

}  // namespace rtb
