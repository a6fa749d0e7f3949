#include "reference/blender_geometry.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/math/frame.h"

namespace rtb {
namespace {

Affined ToObject(const FlatScene& flat, Index object) {
  return flat.objects[static_cast<std::size_t>(object)]
      .object_to_world.Inverse();
}

/// Places points of a plane, given in its frame of two unit tangents.
class PlaneFrame {
 public:
  explicit PlaneFrame(const FlatPlane& plane)
      : point_(plane.own_point), frame_(TangentsOf(plane.own_normal)) {}

  V2d Coordinates(const V3d& own) const {
    return {(own - point_).dot(frame_.s), (own - point_).dot(frame_.t)};
  }
  void Add(const V2d& uv, BlenderMesh* mesh) const {
    mesh->positions.emplace_back(point_ + frame_.s * uv.x + frame_.t * uv.y);
    mesh->uvs.emplace_back(uv);
  }

 private:
  V3d point_;
  Tangents<double> frame_;
};

/// The four trapezoids between square k - 1 and square k.
void AddRing(int k, std::vector<std::array<int, 3>>* triangles) {
  const int inner = 4 * (k - 1);
  const int outer = 4 * k;
  for (int i = 0; i < 4; ++i) {
    const int j = (i + 1) % 4;
    triangles->push_back({outer + i, outer + j, inner + j});
    triangles->push_back({outer + i, inner + j, inner + i});
  }
}

}  // namespace

BlenderMesh BlenderDisk(const FlatScene& flat, const FlatDisk& disk) {
  const Affined to_own = ToObject(flat, disk.object) * disk.unit_to_world;
  const double step = 2 * std::numbers::pi / kDiskSides;
  const double corner = std::sqrt(step / std::sin(step));  // the same area
  BlenderMesh mesh;
  mesh.positions.emplace_back(to_own.origin);
  mesh.uvs.emplace_back(0, 0);
  for (int i = 0; i < kDiskSides; ++i) {
    const V2d p(corner * std::cos(i * step), corner * std::sin(i * step));
    mesh.positions.emplace_back(to_own.Point(V3d(p.x, p.y, 0)));
    mesh.uvs.emplace_back(p * disk.radius);
    mesh.triangles.push_back({0, 1 + i, 1 + (i + 1) % kDiskSides});
  }
  return mesh;
}

BlenderMesh BlenderPlane(const FlatScene& flat, const FlatPlane& plane,
                         const V3d& camera, double reach) {
  const Affined to_own = ToObject(flat, plane.object);
  const PlaneFrame frame(plane);
  const double height = std::abs(plane.normal.dot(camera - plane.point));
  const V3d foot =
      camera - plane.normal * plane.normal.dot(camera - plane.point);
  const V2d middle = frame.Coordinates(to_own.Point(foot));
  // The longest image of a unit of the world in the object's coordinates.
  const double unit =
      std::sqrt(to_own.x.length2() + to_own.y.length2() + to_own.z.length2());
  const double largest = kPlaneReaches * reach * unit;
  BlenderMesh mesh;
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  double half = std::max(height, 1e-3 * reach) * unit;
  for (int k = 0; k == 0 || half < 2 * largest; ++k, half *= 2) {
    for (const V2d& corner : {V2d(-1, -1), V2d(1, -1), V2d(1, 1), V2d(-1, 1)}) {
      frame.Add(middle + corner * half, &mesh);
    }
    if (k > 0) AddRing(k, &mesh.triangles);
  }
  return mesh;
}

BlenderMesh BlenderTriangles(const FlatScene& flat, std::size_t begin,
                             std::size_t end) {
  const Affined to_own = ToObject(flat, flat.triangles[begin].object);
  BlenderMesh mesh;
  for (std::size_t i = begin; i < end; ++i) {
    const FlatTriangle& triangle = flat.triangles[i];
    const auto first = static_cast<int>(mesh.positions.size());
    for (std::size_t k = 0; k < 3; ++k) {
      mesh.positions.emplace_back(to_own.Point(V3d(triangle.vertices[k])));
      mesh.uvs.push_back(triangle.uvs[k]);
    }
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  return mesh;
}

BlenderMesh BlenderMeshOf(const TriangleMesh& mesh) {
  return {mesh.positions, mesh.triangles, mesh.uvs, mesh.normals};
}

}  // namespace rtb
