#include "core/scene/shape_flattener.h"

#include <algorithm>
#include <cmath>

#include "core/math/frame.h"

namespace rtb {
namespace {

/// The map that places the unit sphere or disk: axes s, t, n and a center.
Affined Placed(const V3d& s, const V3d& t, const V3d& n, const V3d& center) {
  Affined map;
  map.x = s;
  map.y = t;
  map.z = n;
  map.origin = center;
  return map;
}

/// Rendering is done in float: beyond this, squares of lengths overflow.
constexpr double kLargest = 1e18;

/// Coordinates in the frame of a triangle's first vertex and the two edges
/// that leave it: the point of the triangle's plane nearest to p.
V2d FrameCoordinates(const V3d& p, const V3d& v0, const V3d& v1,
                     const V3d& v2) {
  const V3d e0 = v1 - v0;
  const V3d e1 = v2 - v0;
  const V3d d = p - v0;
  const V3d n = e0.cross(e1);
  const double area2 = n.length2();
  return {d.cross(e1).dot(n) / area2, e0.cross(d).dot(n) / area2};
}

}  // namespace

bool Representable(const V3d& v) {
  return std::abs(v.x) <= kLargest && std::abs(v.y) <= kLargest &&
         std::abs(v.z) <= kLargest;
}

bool Representable(const Affined& map) {
  const auto all = [](const Affined& m) {
    return Representable(m.x) && Representable(m.y) && Representable(m.z) &&
           Representable(m.origin);
  };
  return all(map) && all(map.Inverse());
}

void ShapeFlattener::operator()(const Sphere& sphere) {
  const double r = sphere.radius;
  const Affined local =
      Placed(V3d(r, 0, 0), V3d(0, r, 0), V3d(0, 0, r), sphere.center);
  flat_.spheres.push_back({Kept(to_world_ * local), object_});
}

void ShapeFlattener::operator()(const Disk& disk) {
  const V3d n = disk.normal.normalized();
  const Tangents<double> frame = TangentsOf(n);
  const double r = disk.radius;
  const Affined local = Placed(frame.s * r, frame.t * r, n * r, disk.center);
  flat_.disks.push_back({Kept(to_world_ * local), object_, r});
}

void ShapeFlattener::operator()(const Plane& plane) {
  const V3d own = plane.normal.normalized();
  const V3d normal = to_world_.Inverse().Transposed(own);
  flat_.planes.push_back({Kept(to_world_.Point(plane.point)),
                          normal.normalized(), object_, plane.point, own});
}

void ShapeFlattener::operator()(const Triangle& triangle) {
  const auto& v = triangle.vertices;
  Add({v[0], {0, 0}}, {v[1], {1, 0}}, {v[2], {0, 1}});
}

void ShapeFlattener::operator()(const Quad& quad) {
  AddQuad(quad.corner, quad.edges[0], quad.edges[1]);
}

void ShapeFlattener::operator()(const Polygon& polygon) {
  const auto& v = polygon.vertices;
  const auto corner = [&](std::size_t i) {
    return Corner{v[i], FrameCoordinates(v[i], v[0], v[1], v[2])};
  };
  for (std::size_t i = 2; i < v.size(); ++i) {
    Add(corner(0), corner(i - 1), corner(i));
  }
}

void ShapeFlattener::operator()(const Box& box) {
  const V3d size = box.max - box.min;
  const V3d x(size.x, 0, 0), y(0, size.y, 0), z(0, 0, size.z);
  // Seen from outside with y up; the top with -z up, the bottom with +z up.
  AddQuad(box.min, z, y);           // -x
  AddQuad(box.min, x, z);           // -y
  AddQuad(box.min + x, -x, y);      // -z
  AddQuad(box.min + x + z, -z, y);  // +x
  AddQuad(box.min + y + z, x, -z);  // +y
  AddQuad(box.min + z, x, y);       // +z
}

void ShapeFlattener::operator()(const Mesh& mesh) {
  const auto& data = scene_.meshes[static_cast<std::size_t>(mesh.data)];
  V3d reach(0);
  for (const V3f& p : data.positions) {
    for (int axis = 0; axis < 3; ++axis) {
      reach[axis] = std::max(reach[axis], std::abs(double{p[axis]}));
    }
  }
  const auto magnitude = [](const V3d& v) {
    return V3d(std::abs(v.x), std::abs(v.y), std::abs(v.z));
  };
  Kept(magnitude(to_world_.x) * reach.x + magnitude(to_world_.y) * reach.y +
       magnitude(to_world_.z) * reach.z + magnitude(to_world_.origin));
  flat_.meshes.push_back({mesh.data, object_});
}

const V3d& ShapeFlattener::Kept(const V3d& v) {
  representable_ = representable_ && Representable(v);
  return v;
}

const Affined& ShapeFlattener::Kept(const Affined& m) {
  representable_ = representable_ && Representable(m);
  return m;
}

void ShapeFlattener::Add(const Corner& a, const Corner& b, const Corner& c) {
  FlatTriangle triangle;
  triangle.object = object_;
  triangle.vertices = {V3f(Kept(to_world_.Point(a.position))),
                       V3f(Kept(to_world_.Point(b.position))),
                       V3f(Kept(to_world_.Point(c.position)))};
  triangle.uvs = {V2f(a.uv), V2f(b.uv), V2f(c.uv)};
  const auto& v = triangle.vertices;
  const V3d normal = V3d(v[1] - v[0]).cross(V3d(v[2] - v[0]));
  if (normal.length2() > 0) flat_.triangles.push_back(triangle);
}

void ShapeFlattener::AddQuad(const V3d& corner, const V3d& e0, const V3d& e1) {
  const Corner first{corner, {0, 0}};
  const Corner opposite{corner + e0 + e1, {1, 1}};
  Add(first, {corner + e0, {1, 0}}, opposite);
  Add(first, opposite, {corner + e1, {0, 1}});
}

}  // namespace rtb
