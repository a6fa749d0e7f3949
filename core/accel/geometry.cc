#include "core/accel/geometry.h"

#include <algorithm>
#include <cmath>

#include "core/math/frame.h"

namespace rtb {
namespace {

float LargestComponent(const V3d& v) {
  return static_cast<float>(
      std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}));
}

/// The linear part alone.
Affined Linear(Affined map) {
  map.origin = V3d(0);
  return map;
}

/// @param third whether the unit shape extends along its third axis.
Quadric MakeQuadric(const Affined& unit_to_world, int object, bool third) {
  const Affined& m = unit_to_world;
  // Half extent of an affine image of the unit sphere: the row norms.
  V3d half(0);
  for (int axis = 0; axis < 3; ++axis) {
    const double z = third ? m.z[axis] : 0;
    half[axis] =
        std::sqrt(m.x[axis] * m.x[axis] + m.y[axis] * m.y[axis] + z * z);
  }
  Quadric quadric;
  quadric.center = V3f(m.origin);
  quadric.to_world = ToFloat(Linear(m));
  quadric.to_unit = ToFloat(Linear(Linear(m).Inverse()));
  quadric.half_extent = V3f(half);
  const V3d reach(std::abs(m.origin.x) + half.x, std::abs(m.origin.y) + half.y,
                  std::abs(m.origin.z) + half.z);
  quadric.scale = LargestComponent(reach);
  quadric.object = object;
  return quadric;
}

PlaneData MakePlane(const FlatPlane& plane, const Affined& object_to_world,
                    int object) {
  const Affined inverse = object_to_world.Inverse();
  const Tangents<double> frame = TangentsOf(plane.own_normal);
  PlaneData data;
  data.point = V3f(plane.point);
  data.normal = V3f(plane.normal);
  data.object = object;
  data.u_axis = V3f(inverse.Transposed(frame.s));
  data.v_axis = V3f(inverse.Transposed(frame.t));
  data.dp_du = V3f(object_to_world.Direction(frame.s));
  data.dp_dv = V3f(object_to_world.Direction(frame.t));
  return data;
}

MeshData MakeMesh(const TriangleMesh& mesh) {
  MeshData data;
  data.positions = mesh.positions.data();
  data.normals = mesh.normals.empty() ? nullptr : mesh.normals.data();
  data.uvs = mesh.uvs.empty() ? nullptr : mesh.uvs.data();
  data.triangles = mesh.triangles.data();
  data.vertex_count = static_cast<int>(mesh.positions.size());
  data.triangle_count = static_cast<int>(mesh.triangles.size());
  return data;
}

/// Appends primitives, whose objects come after those already there.
class Appender {
 public:
  explicit Appender(Geometry* geometry)
      : geometry_(*geometry),
        first_(static_cast<int>(geometry->objects.size())) {}

  void Add(const FlatScene& flat) {
    for (const FlatTriangle& t : flat.triangles) {
      for (const V3f& v : t.vertices) geometry_.vertices.push_back(v);
      for (const V2f& uv : t.uvs) geometry_.uvs.push_back(uv);
      geometry_.triangle_objects.push_back(first_ + t.object);
    }
    for (const FlatSphere& s : flat.spheres) {
      geometry_.spheres.push_back(
          MakeQuadric(s.unit_to_world, first_ + s.object, true));
    }
    for (const FlatDisk& d : flat.disks) {
      geometry_.disks.push_back(
          MakeQuadric(d.unit_to_world, first_ + d.object, false));
      geometry_.disks.back().radius = static_cast<float>(d.radius);
    }
    for (const FlatPlane& p : flat.planes) {
      geometry_.planes.push_back(
          MakePlane(p, ObjectOf(flat, p.object), first_ + p.object));
    }
    for (const FlatMesh& m : flat.meshes) {
      geometry_.uses.push_back(
          {ToFloat(ObjectOf(flat, m.object)), m.mesh, first_ + m.object});
    }
    for (const FlatObject& object : flat.objects) {
      geometry_.objects.push_back({object.material, object.light,
                                   ToFloat(object.object_to_world.Inverse())});
    }
  }

 private:
  static const Affined& ObjectOf(const FlatScene& flat, Index object) {
    return flat.objects[static_cast<std::size_t>(object)].object_to_world;
  }

  Geometry& geometry_;
  const int first_;
};

}  // namespace

GeometryCounts Geometry::counts() const {
  return {triangle_objects.size(), spheres.size(), disks.size(),
          planes.size(),           uses.size(),    objects.size()};
}

Geometry MakeGeometry(const FlatScene& still,
                      std::span<const TriangleMesh> meshes) {
  Geometry geometry;
  for (const TriangleMesh& mesh : meshes) {
    geometry.meshes.push_back(MakeMesh(mesh));
  }
  Appender(&geometry).Add(still);
  geometry.still = geometry.counts();
  return geometry;
}

void ReplaceMoving(const FlatScene& moving, Geometry* geometry) {
  const GeometryCounts& still = geometry->still;
  geometry->vertices.resize(3 * still.triangles);
  geometry->uvs.resize(3 * still.triangles);
  geometry->triangle_objects.resize(still.triangles);
  geometry->spheres.resize(still.spheres);
  geometry->disks.resize(still.disks);
  geometry->planes.resize(still.planes);
  geometry->uses.resize(still.uses);
  geometry->objects.resize(still.objects);
  Appender(geometry).Add(moving);
}

GeometryView ViewOf(const Geometry& geometry) {
  return {geometry.vertices.data(),
          geometry.uvs.data(),
          geometry.triangle_objects.data(),
          geometry.spheres.data(),
          geometry.disks.data(),
          geometry.planes.data(),
          geometry.meshes.data(),
          geometry.uses.data(),
          geometry.objects.data(),
          static_cast<int>(geometry.planes.size())};
}

}  // namespace rtb
