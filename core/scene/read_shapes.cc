#include "core/scene/read_shapes.h"

#include "core/scene/geometry_checks.h"

namespace rtb {
namespace {

using Shape = decltype(Object::shape);

constexpr std::size_t kMinPolygon = 3;
constexpr std::size_t kMaxPolygon = 64;

Shape ReadSphere(MapReader& reader) {
  const V3d center = reader.Vector("center");
  return Sphere{center, reader.Number("radius", kPositive)};
}

Shape ReadPlane(MapReader& reader) {
  const V3d point = reader.Vector("point");
  return Plane{point, reader.Direction("normal")};
}

Shape ReadDisk(MapReader& reader) {
  const V3d center = reader.Vector("center");
  const V3d normal = reader.Direction("normal");
  return Disk{center, normal, reader.Number("radius", kPositive)};
}

Shape ReadTriangle(MapReader& reader) {
  const std::vector<V3d> v = reader.Vectors("vertices", 3, 3);
  if (reader.complete() && AreParallel(v[1] - v[0], v[2] - v[0])) {
    reader.context().Fail(reader.MarkOf("vertices"),
                          "the triangle is degenerate: its edges are "
                          "parallel or zero, expected one that has an area");
  }
  return Triangle{{v[0], v[1], v[2]}};
}

Shape ReadQuad(MapReader& reader) {
  const V3d corner = reader.Vector("corner");
  return Quad{corner, ReadEdges(reader)};
}

Shape ReadPolygon(MapReader& reader) {
  std::vector<V3d> v = reader.Vectors("vertices", kMinPolygon, kMaxPolygon);
  if (reader.complete()) {
    const std::string fault = PolygonFault(v);
    if (!fault.empty()) {
      reader.context().Fail(
          reader.MarkOf("vertices"),
          "the polygon " + fault + ", expected a convex, planar one");
    }
  }
  return Polygon{std::move(v)};
}

Shape ReadBox(MapReader& reader) {
  const V3d min = reader.Vector("min");
  const V3d max = reader.Vector("max");
  const bool ordered = min.x < max.x && min.y < max.y && min.z < max.z;
  if (reader.complete() && !ordered) {
    reader.context().Fail(reader.MarkOf("max"),
                          "`max` is not greater than `min` in each of x, y "
                          "and z, expected min < max");
  }
  return Box{min, max};
}

}  // namespace

std::array<V3d, 2> ReadEdges(MapReader& reader) {
  const std::vector<V3d> edges = reader.Vectors("edges", 2, 2);
  if (reader.complete() && AreParallel(edges[0], edges[1])) {
    reader.context().Fail(reader.MarkOf("edges"),
                          "`edges` are parallel or zero, expected two that "
                          "span an area");
  }
  return {edges[0], edges[1]};
}

std::span<const SimpleShape> SimpleShapes() {
  static const std::array<SimpleShape, 7> kShapes = {{
      {"sphere", ReadSphere},
      {"plane", ReadPlane},
      {"disk", ReadDisk},
      {"triangle", ReadTriangle},
      {"quad", ReadQuad},
      {"polygon", ReadPolygon},
      {"box", ReadBox},
  }};
  return kShapes;
}

}  // namespace rtb
