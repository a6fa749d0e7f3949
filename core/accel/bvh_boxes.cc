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

/// Adds the image of a box, with room for the rounding of a ray's way there.
void AddImage(const Affinef& m, const V3f& lower, const V3f& upper,
              BvhBox* box) {
  const V3f center = m.Point((lower + upper) * 0.5f);
  const V3f half = (upper - lower) * 0.5f;
  const V3f reach = Abs((lower + upper) * 0.5f) + half;
  const V3f scale = Abs(m.x) * reach.x + Abs(m.y) * reach.y +
                    Abs(m.z) * reach.z + Abs(m.origin);
  const V3f extent = Abs(m.x) * half.x + Abs(m.y) * half.y + Abs(m.z) * half.z +
                     V3f(kMargin * MaxAbs(scale));
  box->Add(center - extent, center + extent);
}

/// Adds the images of the boxes `levels` below a node, which together are
/// tighter about a turned mesh than that of the whole.
void AddImages(const Affinef& m, const std::vector<BvhNode>& nodes,
               const BvhNode& node, int levels, BvhBox* box) {
  for (unsigned i = 0; i < kBvhWidth; ++i) {
    const BvhRef child = node.child[i];
    if (child.kind() == BvhKind::kNothing) continue;
    if (child.kind() == BvhKind::kNode && levels > 1) {
      AddImages(m, nodes, nodes[child.index()], levels - 1, box);
      continue;
    }
    const auto& b = node.bounds;
    AddImage(m, V3f(b[0][i], b[2][i], b[4][i]), V3f(b[1][i], b[3][i], b[5][i]),
             box);
  }
}

/// The box around a placed mesh.
BvhBox PlacedBox(const Affinef& to_world, const BvhRoot& root,
                 const std::vector<BvhNode>& nodes) {
  BvhBox box;
  if (root.ref.kind() == BvhKind::kNode) {
    AddImages(to_world, nodes, nodes[root.ref.index()], 2, &box);
  } else {
    AddImage(to_world, V3f(root.lower[0], root.lower[1], root.lower[2]),
             V3f(root.upper[0], root.upper[1], root.upper[2]), &box);
  }
  return box;
}

}  // namespace

std::vector<BvhPrimitive> MeshBoxes(const MeshData& mesh) {
  return TriangleBoxes(0, static_cast<std::size_t>(mesh.triangle_count),
                       CornersOf(mesh));
}

std::vector<BvhPrimitive> PartBoxes(const Geometry& geometry,
                                    std::span<const BvhRoot> mesh_roots,
                                    const std::vector<BvhNode>& mesh_nodes,
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
    const BvhBox box = PlacedBox(use.to_world, root, mesh_nodes);
    boxes.push_back(
        {box.lower, box.upper, BvhKind::kUse, static_cast<std::uint32_t>(i)});
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
