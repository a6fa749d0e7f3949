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

/// Subtrees still to be entered, with where the ray enters them; at the other
/// end, placed meshes that wait until nothing else is left.
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
  /// Lets a placed mesh wait. @return whether there was room.
  RTB_HD bool Defer(BvhRef use) {
    if (deferred_ == kRoom) return false;
    entries_[kCapacity - ++deferred_] = {use, 0};
    return true;
  }
  RTB_HD bool PopDeferred(BvhRef* use) {
    if (deferred_ == 0) return false;
    *use = entries_[kCapacity - deferred_--].ref;
    return true;
  }

 private:
  // A node's children but the one that is entered, on each level.
  static constexpr int kDepthFirst = kMaxBvhDepth * (kBvhWidth - 1) + 1;
  static constexpr int kRoom = 32;
  static constexpr int kCapacity = kDepthFirst + kRoom;
  Entry entries_[kCapacity];
  int size_ = 0;
  int deferred_ = 0;
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

/// Pushes the children met, of which the last is entered next: the builder
/// puts those of the fewest primitives last, which tell soonest whether they
/// block. Placed meshes cost the most and wait.
RTB_HD inline void PushAny(const BvhNode& node, unsigned met, BvhStack* stack) {
  for (; met != 0; met &= met - 1) {
    const BvhRef child = node.child[LowestBit(met)];
    if (child.kind() == BvhKind::kUse && stack->Defer(child)) continue;
    stack->Push({child, 0});
  }
}

/// Visits the leaves of a tree that the ray meets, the near before the far.
/// @tparam Lanes the tests, e.g. PortableLanes.
/// @param leaf answers t_max(), beyond which nothing is of interest, and
/// Visit(ref).
template <class Lanes, class Leaf>
RTB_HD void WalkNearFirst(const BvhNode* nodes, BvhRef root, const BoxRay& ray,
                          Leaf* leaf) {
  BvhStack stack;
  BvhStack::Entry entry{root, 0};
  while (true) {
    while (entry.ref.kind() == BvhKind::kNode) {
      const BvhNode& node = nodes[entry.ref.index()];
      float t[kBvhWidth];
      const unsigned met = Lanes::MeetBoxes(node, ray, leaf->t_max(), t);
      if (met == 0) break;
      entry = EnterNearest(node, met, t, &stack);
    }
    if (entry.ref.kind() != BvhKind::kNode) leaf->Visit(entry.ref);
    do {
      if (stack.empty()) return;
      entry = stack.Pop();
    } while (!(entry.t < leaf->t_max()));
  }
}

/// Visits leaves in the order that may find something soonest, until
/// leaf->Visit(ref) is true.
template <class Lanes, class Leaf>
RTB_HD void WalkUntilMet(const BvhNode* nodes, BvhRef root, const BoxRay& ray,
                         Leaf* leaf) {
  BvhStack stack;
  stack.Push({root, 0});
  while (!stack.empty()) {
    const BvhRef ref = stack.Pop().ref;
    if (ref.kind() == BvhKind::kNode) {
      float t[kBvhWidth];
      const BvhNode& node = nodes[ref.index()];
      PushAny(node, Lanes::MeetBoxes(node, ray, leaf->t_max(), t), &stack);
    } else if (leaf->Visit(ref)) {
      return;
    }
  }
  BvhRef use;
  while (stack.PopDeferred(&use)) {
    if (leaf->Visit(use)) return;
  }
}

/// Takes a ray to the leaves of a tree.
/// @tparam Leaf::kNearFirst in which of the two orders.
template <class Lanes, class Leaf>
RTB_HD void WalkBvh(const BvhNode* nodes, const BvhRoot& root, const V3f& from,
                    const V3f& direction, Leaf* leaf) {
  if (root.ref.kind() == BvhKind::kNothing) return;
  if (root.ref.kind() != BvhKind::kNode) {
    leaf->Visit(root.ref);
    return;
  }
  const BoxRay ray(root, from, direction);
  if constexpr (Leaf::kNearFirst) {
    WalkNearFirst<Lanes>(nodes, root.ref, ray, leaf);
  } else {
    WalkUntilMet<Lanes>(nodes, root.ref, ray, leaf);
  }
}

}  // namespace rtb
