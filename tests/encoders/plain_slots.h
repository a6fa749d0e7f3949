/// @file
/// What choose_in_cell.h and choose_rays.h do, by plain loops over the slots.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "core/math/random.h"
#include "encoders/adaptive/choose_rays.h"

namespace rtb {

/// Where a sample in a slot goes.
inline V2f PlainPosition(int slot, float jitter, int cell, int number,
                         std::uint64_t seed) {
  const auto random = [&](std::uint32_t dimension) {
    return UnitFloat(RandomBits(static_cast<std::uint32_t>(cell),
                                static_cast<std::uint32_t>(number), dimension,
                                seed));
  };
  const V2f unit(random(0), random(1));
  return SlotCenter(slot) + (unit - V2f(0.5f, 0.5f)) *
                                V2f(jitter / kSlotColumns, jitter / kSlotRows);
}

/// The best slot, of equal ones the first.
inline std::size_t PlainBest(const CellSlots& slots) {
  std::size_t best = 0;
  const auto gain = [&](std::size_t i) {
    return Gain(slots.contrast[i], slots.distance2[i], slots.extent[i]);
  };
  for (std::size_t i = 1; i < kSlots; ++i) {
    if (gain(i) > gain(best)) best = i;
  }
  return best;
}

/// ChooseInCell.
/// @param slots what the pointers of `choice` point to.
inline std::vector<RayChoice> PlainChooseInCell(CellSlots slots,
                                                const CellChoice& choice) {
  std::vector<RayChoice> rays;
  while (static_cast<int>(rays.size()) < choice.most) {
    const std::size_t best = PlainBest(slots);
    float& extent = slots.extent[best];
    const float gain =
        Gain(slots.contrast[best], slots.distance2[best], extent);
    if (gain < choice.least) break;
    const V2f position = PlainPosition(
        static_cast<int>(best), extent == kEmptySlot ? kFirstJitter : kJitter,
        choice.cell, choice.seen + static_cast<int>(rays.size()), choice.seed);
    const float reach = kReach * std::sqrt(slots.distance2[best]) + kLeastReach;
    rays.push_back({choice.cell, position, gain, std::min(reach, kCellHeight)});
    extent = WithOneMore(extent);
    for (int slot = 0; slot < kSlots; ++slot) {
      const V2f center = SlotCenter(slot);
      const float dx = (center.x - position.x) * choice.cell_width;
      const float dy = (center.y - position.y) * kCellHeight;
      float& distance2 = slots.distance2[static_cast<std::size_t>(slot)];
      distance2 = std::min(distance2, dx * dx + dy * dy);
    }
  }
  return rays;
}

/// The count-th largest gain; 0 with fewer.
inline float PlainLeast(const std::vector<RayChoice>& rays, int count) {
  const auto n = static_cast<std::size_t>(count);
  if (n > rays.size()) return 0;
  std::vector<float> gains;
  for (const RayChoice& ray : rays) gains.push_back(ray.gain);
  std::ranges::sort(gains, std::greater<>());
  return gains[n - 1];
}

/// All rays of all cells, `most` a cell.
inline std::vector<RayChoice> PlainRays(const VoronoiMap& map,
                                        const SeenSamples& samples, int most,
                                        const RayRequest& request) {
  std::vector<RayChoice> rays;
  for (int cell = 0; cell < samples.grid().cells(); ++cell) {
    CellChoice choice;
    choice.cell_width = map.cell_width();
    choice.cell = cell;
    choice.seen = samples.count(cell);
    choice.most = std::min(most, kMostPerCell - choice.seen);
    choice.seed = request.seed;
    for (const RayChoice& ray : PlainChooseInCell(map.Slots(cell), choice)) {
      rays.push_back(ray);
    }
  }
  return rays;
}

/// ChooseRays: of two a cell, and where a second one gains more than the last
/// of the wanted ones of these does, of all. Of equal gains the first.
inline std::vector<RayChoice> PlainChooseRays(const VoronoiMap& map,
                                              const SeenSamples& samples,
                                              const RayRequest& request) {
  const int few = std::min(2, request.most_per_cell);
  std::vector<RayChoice> rays = PlainRays(map, samples, few, request);
  float least = PlainLeast(rays, request.rays);
  for (std::size_t i = 1; i < rays.size(); ++i) {
    const bool second = few == 2 && rays[i].cell == rays[i - 1].cell;
    if (least > 0 && !(second && rays[i].gain > least)) continue;
    rays = PlainRays(map, samples, request.most_per_cell, request);
    least = PlainLeast(rays, request.rays);
    break;
  }
  int equal = request.rays;
  for (const RayChoice& ray : rays) equal -= ray.gain > least ? 1 : 0;
  std::erase_if(rays, [&](const RayChoice& ray) {
    return ray.gain < least || (ray.gain == least && equal-- <= 0);
  });
  return rays;
}

}  // namespace rtb
