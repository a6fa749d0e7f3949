/// @file
/// From the builder's linked nodes to flat ones.
#pragma once

#include <array>

#include "core/accel/bvh_builder.h"

namespace rtb {

/// Primitives that the builder may put into a leaf.
inline constexpr int kMaxLeafItems = kMaxLeafPacks * kPackWidth;

/// A box from corner to corner; empty as it starts.
struct BvhBox {
  V3f lower{std::numeric_limits<float>::infinity()};
  V3f upper{-std::numeric_limits<float>::infinity()};

  void Add(const V3f& low, const V3f& high);
};

/// What the builder makes: a node or a leaf.
struct Built {
  bool is_leaf = false;
  unsigned count = 0;  ///< Of children, or of items.
};
struct BuiltNode : Built {
  std::array<Built*, kBvhWidth> child{};
  std::array<BvhBox, kBvhWidth> box{};
};
struct BuiltLeaf : Built {
  BuiltLeaf() { is_leaf = true; }
  std::array<BvhPrimitive, kMaxLeafItems> item{};
};

/// Appends a tree to `arrays`, depth first. Leaves of several kinds become
/// nodes.
BvhRoot FlattenBvh(const Built& root, const TriangleCorners& corners,
                   BvhArrays* arrays);

}  // namespace rtb
