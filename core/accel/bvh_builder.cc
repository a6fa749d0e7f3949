#include "core/accel/bvh_builder.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <mutex>
#include <utility>

#include "core/accel/bvh_flatten.h"
#include "core/base/parallel.h"

namespace rtb {
namespace {

// Below this depth the builder splits by counts alone; there are then eight
// levels left, and a node may come on top of a leaf of several kinds.
constexpr unsigned kBuilderDepth = kMaxBvhDepth - 2;

/// What the builder's callbacks share. They run on many threads and take
/// turns: little next to finding the splits. Memory of our own, where
/// sanitizers see who hands what to whom.
struct Shared {
  const std::vector<BvhPrimitive>& primitives;
  std::mutex guard{};
  std::deque<BuiltNode> nodes{};
  std::deque<BuiltLeaf> leaves{};
};

/// The shared data for the length of a callback.
class Turn {
 public:
  explicit Turn(void* shared)
      : shared_(*static_cast<Shared*>(shared)), lock_(shared_.guard) {}
  Shared* operator->() const { return &shared_; }

 private:
  Shared& shared_;
  const std::lock_guard<std::mutex> lock_;
};

void* CreateNode(RTCThreadLocalAllocator, unsigned count, void* shared) {
  const Turn turn(shared);
  BuiltNode& node = turn->nodes.emplace_back();
  node.count = count;
  return static_cast<Built*>(&node);
}

BuiltNode* NodeOf(void* built) {
  return static_cast<BuiltNode*>(static_cast<Built*>(built));
}

void SetChildren(void* node, void** children, unsigned count, void* shared) {
  const Turn turn(shared);
  for (unsigned i = 0; i < count; ++i) {
    NodeOf(node)->child[i] = static_cast<Built*>(children[i]);
  }
}

void SetBounds(void* node, const RTCBounds** bounds, unsigned count,
               void* shared) {
  const Turn turn(shared);
  for (unsigned i = 0; i < count; ++i) {
    const RTCBounds& b = *bounds[i];
    NodeOf(node)->box[i] = {V3f(b.lower_x, b.lower_y, b.lower_z),
                            V3f(b.upper_x, b.upper_y, b.upper_z)};
  }
}

void* CreateLeaf(RTCThreadLocalAllocator, const RTCBuildPrimitive* items,
                 std::size_t count, void* shared) {
  // In one order, however threads shared the work.
  std::array<unsigned, kMaxLeafItems> order{};
  for (std::size_t i = 0; i < count; ++i) order[i] = items[i].primID;
  std::sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count));
  const Turn turn(shared);
  BuiltLeaf& leaf = turn->leaves.emplace_back();
  leaf.count = static_cast<unsigned>(count);
  for (std::size_t i = 0; i < count; ++i) {
    leaf.item[i] = turn->primitives[order[i]];
  }
  return static_cast<Built*>(&leaf);
}

bool IsFinite(const BvhPrimitive& p) {
  const V3f sum = p.lower + p.upper;
  return std::isfinite(sum.x) && std::isfinite(sum.y) && std::isfinite(sum.z);
}

std::vector<RTCBuildPrimitive> ToRtc(const std::vector<BvhPrimitive>& all) {
  std::vector<RTCBuildPrimitive> result;
  result.reserve(all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    const BvhPrimitive& p = all[i];
    if (!IsFinite(p)) continue;
    result.push_back({p.lower.x, p.lower.y, p.lower.z, 0, p.upper.x, p.upper.y,
                      p.upper.z, static_cast<unsigned>(i)});
  }
  return result;
}

RTCBuildArguments Arguments(RTCBVH bvh, Shared* shared,
                            std::vector<RTCBuildPrimitive>* items) {
  RTCBuildArguments arguments = rtcDefaultBuildArguments();
  arguments.maxBranchingFactor = kBvhWidth;
  arguments.maxDepth = kBuilderDepth;
  arguments.sahBlockSize = kPackWidth;
  arguments.minLeafSize = kPackWidth;
  arguments.maxLeafSize = kMaxLeafItems;
  arguments.bvh = bvh;
  arguments.primitives = items->data();
  arguments.primitiveCount = items->size();
  arguments.primitiveArrayCapacity = items->size();
  arguments.createNode = CreateNode;
  arguments.setNodeChildren = SetChildren;
  arguments.setNodeBounds = SetBounds;
  arguments.createLeaf = CreateLeaf;
  arguments.userPtr = shared;
  return arguments;
}

Error OutOfMemory() {
  return Failure("bvh", "not enough memory for the scene's geometry",
                 "use fewer or smaller meshes, or fewer instances");
}

}  // namespace

struct BvhBuilder::Device {
  RTCDevice rtc = rtcNewDevice("");
  Device() = default;
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;
  ~Device() {
    if (rtc != nullptr) rtcReleaseDevice(rtc);
  }
};

BvhBuilder::BvhBuilder(std::unique_ptr<Device> device)
    : device_(std::move(device)) {}
BvhBuilder::BvhBuilder(BvhBuilder&&) noexcept = default;
BvhBuilder& BvhBuilder::operator=(BvhBuilder&&) noexcept = default;
BvhBuilder::~BvhBuilder() = default;

Result<BvhBuilder> BvhBuilder::Make() {
  auto device = std::make_unique<Device>();
  if (device->rtc == nullptr) return Fail(OutOfMemory());
  return BvhBuilder(std::move(device));
}

Result<BvhRoot> BvhBuilder::Build(const std::vector<BvhPrimitive>& primitives,
                                  const TriangleCorners& corners, int threads,
                                  BvhArrays* arrays) const {
  std::vector<RTCBuildPrimitive> items = ToRtc(primitives);
  if (items.empty()) return BvhRoot{};
  const RTCBVH bvh = rtcNewBVH(device_->rtc);
  if (bvh == nullptr) return Fail(OutOfMemory());
  Shared shared{primitives};
  const RTCBuildArguments arguments = Arguments(bvh, &shared, &items);
  void* root = nullptr;
  RunBounded(threads, [&] { root = rtcBuildBVH(&arguments); });
  rtcReleaseBVH(bvh);
  if (root == nullptr) return Fail(OutOfMemory());
  const Turn turn(&shared);
  return FlattenBvh(*static_cast<const Built*>(root), corners, arrays);
}

}  // namespace rtb
