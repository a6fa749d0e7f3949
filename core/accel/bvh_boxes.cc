#include "core/accel/bvh_boxes.h"

#include "core/accel/bvh_flatten.h"
#include "core/accel/surface.h"

namespace rtb {
namespace {

/// The share of the largest coordinate that a box grows by.
constexpr float kMargin = 0x1p-18f;

std::vector<BvhPrimitive> TriangleBoxes(std::size_t begin, std::size_t end,
                                        const TriangleCorners& corners) {
  std::vector<BvhPrimitive> boxes;
  boxes.reserve(end - begin);
  for (std::size_t i = begin; i < end; ++i) {
    const auto index = static_cast<std::uint32_t>(i);
    BvhBox box;
    for (const V3f& corner : corners(index)) box.Add(corner, corner);
    boxes.push_back({box.lower, box.upper, BvhKind::kTriangles, index});
  }
  return boxes;
}

void AddQuadrics(const std::vector<Quadric>& quadrics, BvhKind kind,
                 std::size_t begin, std::size_t end,
                 std::vector<BvhPrimitive>* boxes) {
  for (std::size_t i = begin; i < end; ++i) {
    const Quadric& q = quadrics[i];
    const V3f half = q.half_extent + V3f(kMargin * q.scale);
    boxes->push_back({q.center - half, q.center + half, kind,
                      static_cast<std::uint32_t>(i)});
  }
}

/// The box around a box's image.
BvhPrimitive PlacedBox(const MeshUse& use, const BvhRoot& root,
                       std::uint32_t index) {
  const Affinef& m = use.to_world;
  V3f middle(0), half(0), reach(0);
  for (int axis = 0; axis < 3; ++axis) {
    const float lower = root.lower[axis], upper = root.upper[axis];
    middle[axis] = (lower + upper) * 0.5f;
    half[axis] = (upper - lower) * 0.5f;
    reach[axis] = std::max(std::abs(lower), std::abs(upper));
  }
  const V3f center = m.Point(middle);
  V3f extent = Abs(m.x) * half.x + Abs(m.y) * half.y + Abs(m.z) * half.z;
  // What enters a placed position, and a ray's way into mesh space.
  const V3f scale = Abs(m.x) * reach.x + Abs(m.y) * reach.y +
                    Abs(m.z) * reach.z + Abs(m.origin);
  extent += V3f(kMargin * MaxAbs(scale));
  return {center - extent, center + extent, BvhKind::kUse, index};
}

}  // namespace

std::vector<BvhPrimitive> MeshBoxes(const MeshData& mesh) {
  return TriangleBoxes(0, static_cast<std::size_t>(mesh.triangle_count),
                       CornersOf(mesh));
}

std::vector<BvhPrimitive> PartBoxes(const Geometry& geometry,
                                    std::span<const BvhRoot> mesh_roots,
                                    const GeometryCounts& begin,
                                    const GeometryCounts& end) {
  std::vector<BvhPrimitive> boxes =
      TriangleBoxes(begin.triangles, end.triangles, CornersOf(geometry));
  AddQuadrics(geometry.spheres, BvhKind::kSphere, begin.spheres, end.spheres,
              &boxes);
  AddQuadrics(geometry.disks, BvhKind::kDisk, begin.disks, end.disks, &boxes);
  for (std::size_t i = begin.uses; i < end.uses; ++i) {
    const MeshUse& use = geometry.uses[i];
    const BvhRoot& root = mesh_roots[static_cast<std::size_t>(use.mesh)];
    if (root.ref.kind() == BvhKind::kNothing) continue;  // no triangles
    boxes.push_back(PlacedBox(use, root, static_cast<std::uint32_t>(i)));
  }
  return boxes;
}

TriangleCorners CornersOf(const MeshData& mesh) {
  return [&mesh](std::uint32_t index) {
    const auto& [a, b, c] = mesh.triangles[index];
    return std::array<V3f, 3>{mesh.positions[a], mesh.positions[b],
                              mesh.positions[c]};
  };
}

TriangleCorners CornersOf(const Geometry& geometry) {
  return [&geometry](std::uint32_t index) {
    const V3f* v = geometry.vertices.data() + 3 * std::size_t{index};
    return std::array<V3f, 3>{v[0], v[1], v[2]};
  };
}

}  // namespace rtb
