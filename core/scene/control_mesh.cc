#include "core/scene/control_mesh.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "core/scene/triple_index.h"

namespace rtb {
namespace {

/// The bits of a finite float; both zeros have the same.
std::uint32_t Bits(float x) { return std::bit_cast<std::uint32_t>(x + 0.0f); }

void AddPoints(const TriangleMesh& mesh, ControlMesh* control) {
  TripleIndex numbers;
  for (const auto& triangle : mesh.triangles) {
    for (const int vertex : triangle) {
      const V3f& p = mesh.positions[static_cast<std::size_t>(vertex)];
      const auto [point, added] =
          numbers.Number({Bits(p.x), Bits(p.y), Bits(p.z)});
      if (added) control->points.emplace_back(p);
      control->point_corners.push_back(point);
    }
  }
}

void AddUvs(const TriangleMesh& mesh, ControlMesh* control) {
  TripleIndex numbers;
  auto point = control->point_corners.begin();
  for (const auto& triangle : mesh.triangles) {
    for (const int vertex : triangle) {
      const V2f& uv = mesh.uvs[static_cast<std::size_t>(vertex)];
      const auto [value, added] = numbers.Number(
          {static_cast<std::uint32_t>(*point++), Bits(uv.x), Bits(uv.y)});
      if (added) control->uvs.emplace_back(uv);
      control->uv_corners.push_back(value);
    }
  }
}

using Edge = std::pair<int, int>;

/// The directed edges that stand alone, sorted.
std::vector<Edge> BoundaryEdges(const std::vector<int>& corners) {
  std::vector<Edge> edges;
  for (std::size_t i = 0; i < corners.size(); i += 3) {
    for (std::size_t k = 0; k < 3; ++k) {
      edges.emplace_back(corners[i + k], corners[i + (k + 1) % 3]);
    }
  }
  std::sort(edges.begin(), edges.end());
  std::vector<Edge> alone;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const bool repeated = (i > 0 && edges[i - 1] == edges[i]) ||
                          (i + 1 < edges.size() && edges[i + 1] == edges[i]);
    const Edge back(edges[i].second, edges[i].first);
    if (repeated || std::binary_search(edges.begin(), edges.end(), back)) {
      continue;
    }
    alone.push_back(edges[i]);
  }
  return alone;
}

/// The neighbors of a point along the boundary; with several boundaries
/// through it there is no telling which belong together.
struct Along {
  int before = kNone;
  int after = kNone;
  bool several = false;
};

void Set(int neighbor, int* place, Along* along) {
  along->several = along->several || *place != kNone;
  *place = neighbor;
}

void AddSharpCorners(ControlMesh* control) {
  constexpr double kCosineOfTurn = 0.42261826174069944;  // 65 degrees
  const std::vector<V3d>& points = control->points;
  std::vector<Along> boundary(points.size());
  for (const auto& [from, to] : BoundaryEdges(control->point_corners)) {
    Along& start = boundary[static_cast<std::size_t>(from)];
    Along& end = boundary[static_cast<std::size_t>(to)];
    Set(to, &start.after, &start);
    Set(from, &end.before, &end);
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto& [before, after, several] = boundary[i];
    if (several || before == kNone || after == kNone) continue;
    const V3d in = points[i] - points[static_cast<std::size_t>(before)];
    const V3d out = points[static_cast<std::size_t>(after)] - points[i];
    if (in.normalized().dot(out.normalized()) < kCosineOfTurn) {
      control->sharp_corners.push_back(static_cast<int>(i));
    }
  }
}

}  // namespace

ControlMesh Connect(const TriangleMesh& mesh) {
  ControlMesh control;
  AddPoints(mesh, &control);
  if (!mesh.uvs.empty()) AddUvs(mesh, &control);
  AddSharpCorners(&control);
  return control;
}

}  // namespace rtb
