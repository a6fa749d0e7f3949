/// @file
/// Texture coordinates of a surface point and how the surface runs with them,
/// as the scene format defines them for each shape.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/accel/surface.h"
#include "core/math/constants.h"
#include "core/math/frame.h"

namespace rtb {

/// (u, v) at a point and the derivatives of the world position by them.
struct SurfaceUv {
  V2f uv{0, 0};
  V3f dp_du{0};
  V3f dp_dv{0};
};

/// Coordinates on a triangle with edges e0, e1 from its first corner; where
/// its texture coordinates span no area, any tangents (Pharr, Jakob and
/// Humphreys, Physically Based Rendering, 3.6.2).
RTB_HD inline SurfaceUv TriangleUv(const V2f& a, const V2f& b, const V2f& c,
                                   const V3f& e0, const V3f& e1, const Hit& hit,
                                   const V3f& normal) {
  const V2f d0 = b - a;
  const V2f d1 = c - a;
  SurfaceUv result;
  result.uv = a + d0 * hit.u + d1 * hit.v;
  const float determinant = d0.x * d1.y - d0.y * d1.x;
  if (determinant == 0) {
    const Tangents<float> frame = TangentsOf(normal);
    result.dp_du = frame.s;
    result.dp_dv = frame.t;
    return result;
  }
  result.dp_du = (e0 * d1.y - e1 * d0.y) / determinant;
  result.dp_dv = (e1 * d0.x - e0 * d1.x) / determinant;
  return result;
}

RTB_HD inline SurfaceUv MeshUv(const GeometryView& g, const Hit& hit,
                               const V3f& normal) {
  const MeshUse& use = g.uses[hit.use];
  const MeshData& mesh = g.meshes[use.mesh];
  const auto& [a, b, c] = mesh.triangles[hit.primitive];
  const V3f& v0 = mesh.positions[a];
  const V3f e0 = use.to_world.Direction(mesh.positions[b] - v0);
  const V3f e1 = use.to_world.Direction(mesh.positions[c] - v0);
  if (mesh.uvs == nullptr) {
    return TriangleUv(V2f(0, 0), V2f(1, 0), V2f(0, 1), e0, e1, hit, normal);
  }
  return TriangleUv(mesh.uvs[a], mesh.uvs[b], mesh.uvs[c], e0, e1, hit, normal);
}

/// u = 0.5 + atan2(-z, x) / 2 pi, v = 0.5 + asin(y) / pi on the unit sphere.
RTB_HD inline SurfaceUv SphereUv(const Quadric& sphere, const V3f& position) {
  const V3f p = sphere.to_unit.Direction(position - sphere.center).normalized();
  const float around = std::sqrt(p.x * p.x + p.z * p.z);
  const float c = std::max(around, 1e-6f);
  SurfaceUv result;
  result.uv = V2f(0.5f + std::atan2(-p.z, p.x) / (2 * kPi),
                  0.5f + std::atan2(p.y, around) / kPi);
  const V3f along_u = around > 0 ? V3f(p.z, 0, -p.x) : V3f(0, 0, -c);
  const V3f along_v(-p.y * p.x / c, around, -p.y * p.z / c);
  result.dp_du = sphere.to_world.Direction(along_u * (2 * kPi));
  result.dp_dv = sphere.to_world.Direction(along_v * kPi);
  return result;
}

RTB_HD inline SurfaceUv DiskUv(const Quadric& disk, const V3f& position) {
  const V3f p = disk.to_unit.Direction(position - disk.center);
  return {V2f(p.x, p.y) * disk.radius, disk.to_world.x / disk.radius,
          disk.to_world.y / disk.radius};
}

RTB_HD inline SurfaceUv PlaneUv(const PlaneData& plane, const V3f& position) {
  const V3f d = position - plane.point;
  return {V2f(d.dot(plane.u_axis), d.dot(plane.v_axis)), plane.dp_du,
          plane.dp_dv};
}

/// The texture coordinates at a hit whose surface point is known.
RTB_HD inline SurfaceUv UvAt(const GeometryView& g, const Hit& hit,
                             const SurfacePoint& point) {
  switch (hit.kind) {
    case PrimitiveKind::kTriangle: {
      const std::size_t first = 3 * static_cast<std::size_t>(hit.primitive);
      const V3f* v = g.vertices + first;
      const V2f* uv = g.uvs + first;
      return TriangleUv(uv[0], uv[1], uv[2], v[1] - v[0], v[2] - v[0], hit,
                        point.normal);
    }
    case PrimitiveKind::kMesh:
      return MeshUv(g, hit, point.normal);
    case PrimitiveKind::kSphere:
      return SphereUv(g.spheres[hit.primitive], point.position);
    case PrimitiveKind::kDisk:
      return DiskUv(g.disks[hit.primitive], point.position);
    default:
      return PlaneUv(g.planes[hit.primitive], point.position);
  }
}

}  // namespace rtb
