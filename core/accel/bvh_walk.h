/// @file
/// The walk through one tree of a BVH.
#pragma once

#include "core/accel/bvh_ray.h"
#include "core/accel/bvh_view.h"
#include "core/base/host_device.h"

namespace rtb {

/// The number of the lowest bit that is set; `bits` is not 0.
RTB_HD inline int LowestBit(unsigned bits) {
#ifdef __CUDA_ARCH__
  return __ffs(static_cast<int>(bits)) - 1;
#else
  return __builtin_ctz(bits);
#endif
}

/// Subtrees still to be entered, with where the ray enters them.
class BvhStack {
 public:
  struct Entry {
    BvhRef ref;
    float t;
  };

  RTB_HD bool empty() const { return size_ == 0; }
  RTB_HD int size() const { return size_; }
  RTB_HD Entry Pop() { return entries_[--size_]; }
  RTB_HD void Push(const Entry& entry) { entries_[size_++] = entry; }
  /// Pushes so that from `base` on the nearest stays on top.
  RTB_HD void Insert(int base, const Entry& entry) {
    int place = size_++;
    for (; place > base && entries_[place - 1].t < entry.t; --place) {
      entries_[place] = entries_[place - 1];
    }
    entries_[place] = entry;
  }

 private:
  // A node's children but the one that is entered, on each level.
  Entry entries_[kMaxBvhDepth * (kBvhWidth - 1) + 1];
  int size_ = 0;
};

/// Enters the nearest of the children met; the others wait.
RTB_HD inline BvhStack::Entry EnterNearest(const BvhNode& node, unsigned met,
                                           const float* t, BvhStack* stack) {
  const int first = LowestBit(met);
  BvhStack::Entry nearest{node.child[first], t[first]};
  const int base = stack->size();
  for (met &= met - 1; met != 0; met &= met - 1) {
    const int i = LowestBit(met);
    BvhStack::Entry next{node.child[i], t[i]};
    if (next.t < nearest.t) {
      const BvhStack::Entry swapped = next;
      next = nearest;
      nearest = swapped;
    }
    stack->Insert(base, next);
  }
  return nearest;
}

/// Enters the last of the children met: the builder puts those of the fewest
/// primitives last, which tell soonest whether they block.
RTB_HD inline BvhStack::Entry EnterAny(const BvhNode& node, unsigned met,
                                       BvhStack* stack) {
  for (; (met & (met - 1)) != 0; met &= met - 1) {
    stack->Push({node.child[LowestBit(met)], 0});
  }
  return {node.child[LowestBit(met)], 0};
}

/// Visits the leaves of a tree that the ray meets, the near before the far
/// where Leaf::kNearFirst says that it is of use.
/// @tparam Lanes the tests, e.g. PortableLanes.
/// @param leaf answers t_max(), beyond which nothing is of interest, and
/// Visit(ref), which returns whether the walk ends there.
template <class Lanes, class Leaf>
RTB_HD void WalkBvh(const BvhNode* nodes, const BvhRoot& root, const V3f& from,
                    const V3f& direction, Leaf* leaf) {
  if (root.ref.kind() != BvhKind::kNode) {
    if (root.ref.kind() != BvhKind::kNothing) leaf->Visit(root.ref);
    return;
  }
  const BoxRay ray(root, from, direction);
  BvhStack stack;
  BvhStack::Entry entry{root.ref, 0};
  while (true) {
    while (entry.ref.kind() == BvhKind::kNode) {
      const BvhNode& node = nodes[entry.ref.index()];
      float t[kBvhWidth];
      const unsigned met = Lanes::MeetBoxes(node, ray, leaf->t_max(), t);
      if (met == 0) break;
      if constexpr (Leaf::kNearFirst) {
        entry = EnterNearest(node, met, t, &stack);
      } else {
        entry = EnterAny(node, met, &stack);
      }
    }
    if (entry.ref.kind() != BvhKind::kNode && leaf->Visit(entry.ref)) return;
    do {
      if (stack.empty()) return;
      entry = stack.Pop();
    } while (!(entry.t < leaf->t_max()));
  }
}

}  // namespace rtb
