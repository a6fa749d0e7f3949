/// @file
/// BvhBuilder: from boxes to the flat nodes of one tree. The only part of the
/// BVH that knows of Embree, whose builder API finds the splits.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <vector>

#include "core/accel/bvh_view.h"
#include "core/base/result.h"

namespace rtb {

/// A primitive and the box around it.
struct BvhPrimitive {
  V3f lower{0};
  V3f upper{0};
  BvhKind kind = BvhKind::kNothing;
  std::uint32_t index = 0;
};

/// The nodes and packs of one tree, or of several.
struct BvhArrays {
  std::vector<BvhNode> nodes;
  std::vector<TrianglePack> packs;

  BvhTables tables() const { return {nodes.data(), packs.data()}; }
};

/// The corners of a triangle by its index.
using TriangleCorners = std::function<std::array<V3f, 3>(std::uint32_t)>;

/// Builds trees; the same for the same primitives, whatever the number of
/// threads.
class BvhBuilder {
 public:
  /// @return an Error when Embree cannot be had.
  static Result<BvhBuilder> Make();

  BvhBuilder(BvhBuilder&&) noexcept;
  BvhBuilder& operator=(BvhBuilder&&) noexcept;
  ~BvhBuilder();

  /// Appends a tree over primitives to `arrays`. Primitives whose box is not
  /// finite are left out.
  /// @param threads at most this many; 0 = all cores.
  /// @return its root, or an Error when memory is short.
  Result<BvhRoot> Build(const std::vector<BvhPrimitive>& primitives,
                        const TriangleCorners& corners, int threads,
                        BvhArrays* arrays) const;

 private:
  struct Device;
  explicit BvhBuilder(std::unique_ptr<Device> device);
  std::unique_ptr<Device> device_;
};

}  // namespace rtb
