/// @file
/// BvhView: a flat bounding volume hierarchy as bare pointers, for host and
/// device code. The flow: Geometry -> BvhAccel -> BvhView -> BvhTracer.
#pragma once

#include <cstdint>

#include "core/accel/geometry.h"
#include "core/base/host_device.h"

namespace rtb {

/// Children of a node.
inline constexpr int kBvhWidth = 8;
/// Triangles of a pack.
inline constexpr int kPackWidth = 4;
/// Packs of a leaf at most.
inline constexpr int kMaxLeafPacks = 2;
/// Nodes on a way from the root to a leaf at most: bounds the stacks.
inline constexpr int kMaxBvhDepth = 24;

/// What a reference to a child names.
enum class BvhKind : std::uint32_t {
  kNode,
  kTriangles,  ///< Packs in a row.
  kSphere,     ///< One of the geometry's.
  kDisk,
  kUse,  ///< A placed mesh.
  kNothing
};

/// A reference to a node or to what a leaf holds: kind, a count less one (of
/// packs), and the index of the first, in one word.
struct BvhRef {
  static constexpr std::uint32_t kIndexBits = 28;
  static constexpr std::uint32_t kMaxIndex = (1u << kIndexBits) - 1;
  static_assert(kMaxLeafPacks <= 2, "one bit holds the count");

  std::uint32_t bits = static_cast<std::uint32_t>(BvhKind::kNothing) << 29;

  /// @param index up to kMaxIndex.
  RTB_HD static BvhRef Make(BvhKind kind, std::uint32_t index,
                            std::uint32_t count = 1) {
    return {static_cast<std::uint32_t>(kind) << 29 | (count - 1) << kIndexBits |
            index};
  }
  RTB_HD BvhKind kind() const { return static_cast<BvhKind>(bits >> 29); }
  RTB_HD std::uint32_t index() const { return bits & kMaxIndex; }
  RTB_HD std::uint32_t count() const { return (bits >> kIndexBits & 1) + 1; }
};

/// The boxes of up to eight children, and what they are. Boxes that are not
/// there are inside out.
struct alignas(32) BvhNode {
  /// bounds[2 * axis] the lower, bounds[2 * axis + 1] the upper ends.
  float bounds[6][kBvhWidth];
  BvhRef child[kBvhWidth];
};

/// Up to four triangles; the last one stands in for those that are not there.
struct alignas(16) TrianglePack {
  float corner[3][3][kPackWidth];  ///< [corner][axis][triangle].
  std::uint32_t id[kPackWidth];    ///< In the mesh, or in the geometry.
};

/// The root of a tree and the box around all of it.
struct BvhRoot {
  BvhRef ref;
  float lower[3] = {0, 0, 0};
  float upper[3] = {0, 0, 0};
};

/// Nodes and packs of one tree, or of several.
struct BvhTables {
  const BvhNode* nodes = nullptr;
  const TrianglePack* packs = nullptr;
};

/// Two levels: the trees of what stands still and of what moves hold single
/// triangles, spheres, disks and placed meshes; each mesh has a tree of its
/// own, in its own coordinates. All trees of meshes share their tables.
/// Trivially copyable; on a device its pointers, those of `geometry` and those
/// of the geometry's meshes are the device's.
struct BvhView {
  BvhTables still;
  BvhTables moving;
  BvhTables meshes;
  BvhRoot still_root;
  BvhRoot moving_root;
  const BvhRoot* mesh_roots = nullptr;  ///< One for each of the meshes.
  GeometryView geometry;
  /// Per object: the share of light that passes straight through its surface
  /// at one crossing.
  const Rgb* transmittance = nullptr;
};

}  // namespace rtb
