#include "core/accel/bvh_flatten.h"

#include <algorithm>
#include <span>

#include "core/base/check.h"

namespace rtb {
namespace {

using Items = std::span<const BvhPrimitive>;

/// A child that is still to be written into its node.
struct FlatChild {
  BvhRef ref;
  BvhBox box;
};

BvhBox BoxOf(Items items) {
  BvhBox box;
  for (const BvhPrimitive& item : items) box.Add(item.lower, item.upper);
  return box;
}

std::uint32_t NextIndex(std::size_t size) {
  RTB_CHECK_LE(size, std::size_t{BvhRef::kMaxIndex});
  return static_cast<std::uint32_t>(size);
}

class Flattener {
 public:
  Flattener(const TriangleCorners& corners, BvhArrays* arrays)
      : corners_(corners), arrays_(*arrays) {}

  /// @param depth nodes on the way here.
  FlatChild Add(const Built& built, int depth) {
    if (built.is_leaf) {
      const auto& leaf = static_cast<const BuiltLeaf&>(built);
      return AddLeaf(Items(leaf.item).first(leaf.count), depth);
    }
    const auto& node = static_cast<const BuiltNode&>(built);
    const std::uint32_t index = AddNode(depth);
    FlatChild result{BvhRef::Make(BvhKind::kNode, index), {}};
    for (unsigned i = 0; i < node.count; ++i) {
      FlatChild child = Add(*node.child[i], depth + 1);
      child.box = node.box[i];
      SetChild(index, i, child);
      result.box.Add(child.box.lower, child.box.upper);
    }
    return result;
  }

 private:
  /// An empty node.
  std::uint32_t AddNode(int depth) {
    RTB_CHECK_LT(depth, kMaxBvhDepth);
    const std::uint32_t index = NextIndex(arrays_.nodes.size());
    arrays_.nodes.emplace_back();
    for (unsigned i = 0; i < kBvhWidth; ++i) SetChild(index, i, {});
    return index;
  }

  void SetChild(std::uint32_t index, unsigned i, const FlatChild& child) {
    BvhNode& node = arrays_.nodes[index];
    for (int axis = 0; axis < 3; ++axis) {
      node.bounds[2 * axis][i] = child.box.lower[axis];
      node.bounds[2 * axis + 1][i] = child.box.upper[axis];
    }
    node.child[i] = child.ref;
  }

  FlatChild AddLeaf(Items items, int depth) {
    if (items.front().kind != BvhKind::kTriangles && items.size() == 1) {
      return {BvhRef::Make(items[0].kind, items[0].index), BoxOf(items)};
    }
    std::array<BvhPrimitive, kMaxLeafItems> sorted{};
    std::copy(items.begin(), items.end(), sorted.begin());
    const auto end = sorted.begin() + static_cast<std::ptrdiff_t>(items.size());
    const auto others = std::stable_partition(
        sorted.begin(), end,
        [](const BvhPrimitive& p) { return p.kind == BvhKind::kTriangles; });
    const Items triangles(sorted.begin(), others);
    if (others == end) return AddTriangles(triangles);
    const std::uint32_t index = AddNode(depth);
    unsigned count = 0;
    if (!triangles.empty()) SetChild(index, count++, AddTriangles(triangles));
    for (auto p = others; p != end; ++p) {
      SetChild(index, count++,
               {BvhRef::Make(p->kind, p->index), BoxOf({&*p, 1})});
    }
    return {BvhRef::Make(BvhKind::kNode, index), BoxOf(items)};
  }

  FlatChild AddTriangles(Items triangles) {
    const std::uint32_t first = NextIndex(arrays_.packs.size());
    std::uint32_t packs = 0;
    for (Items rest = triangles; !rest.empty(); ++packs) {
      const std::size_t count = std::min<std::size_t>(rest.size(), kPackWidth);
      AddPack(rest.first(count));
      rest = rest.subspan(count);
    }
    return {BvhRef::Make(BvhKind::kTriangles, first, packs), BoxOf(triangles)};
  }

  void AddPack(Items triangles) {
    TrianglePack pack;
    for (std::size_t i = 0; i < kPackWidth; ++i) {
      const std::size_t k = std::min(i, triangles.size() - 1);
      pack.id[i] = triangles[k].index;
      const std::array<V3f, 3> corners = corners_(triangles[k].index);
      for (std::size_t corner = 0; corner < 3; ++corner) {
        for (int axis = 0; axis < 3; ++axis) {
          pack.corner[corner][axis][i] = corners[corner][axis];
        }
      }
    }
    arrays_.packs.push_back(pack);
  }

  const TriangleCorners& corners_;
  BvhArrays& arrays_;
};

}  // namespace

void BvhBox::Add(const V3f& low, const V3f& high) {
  for (int axis = 0; axis < 3; ++axis) {
    lower[axis] = std::min(lower[axis], low[axis]);
    upper[axis] = std::max(upper[axis], high[axis]);
  }
}

BvhRoot FlattenBvh(const Built& root, const TriangleCorners& corners,
                   BvhArrays* arrays) {
  const FlatChild all = Flattener(corners, arrays).Add(root, 0);
  BvhRoot result{all.ref};
  for (int axis = 0; axis < 3; ++axis) {
    result.lower[axis] = all.box.lower[axis];
    result.upper[axis] = all.box.upper[axis];
  }
  return result;
}

}  // namespace rtb
