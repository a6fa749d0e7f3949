/// @file
/// What choose_in_cells.h and choose_rays.h do, by plain loops over the slots.
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
  return PlaceInSlot(slot, jitter, V2f(random(0), random(1)));
}

/// From a slot's center to a place in its cell, squared.
inline float PlainDistance2(std::size_t slot, float cell_width,
                            const V2f& place) {
  const auto column = static_cast<float>(slot % kSlotColumns) + 0.5f;
  const auto row = static_cast<float>(slot / kSlotColumns) + 0.5f;
  const float dx = column * (cell_width / kSlotColumns) - place.x * cell_width;
  const float dy = row * (kCellHeight / kSlotRows) - place.y * kCellHeight;
  return dx * dx + dy * dy;
}

/// The best slot, of equal ones the first.
inline std::size_t PlainBest(const CellSlots& slots) {
  std::size_t best = 0;
  const auto gain = [&](std::size_t i) {
    return Gain(slots.contrast[i], slots.distance2[i],
                ExtentOf(slots.samples[i]));
  };
  for (std::size_t i = 1; i < kSlots; ++i) {
    if (gain(i) > gain(best)) best = i;
  }
  return best;
}

/// ChooseInCells, for one of them.
inline std::vector<RayChoice> PlainChooseInCell(const CellChoice& choice,
                                                const ChoiceTerms& terms) {
  CellSlots slots = *choice.slots;
  std::vector<RayChoice> rays;
  while (static_cast<int>(rays.size()) < choice.most) {
    const std::size_t best = PlainBest(slots);
    std::uint8_t& samples = slots.samples[best];
    const float gain =
        Gain(slots.contrast[best], slots.distance2[best], ExtentOf(samples));
    if (gain < terms.least) break;
    const V2f position = PlainPosition(
        static_cast<int>(best), samples == 0 ? kFirstJitter : kJitter,
        choice.cell, choice.seen + static_cast<int>(rays.size()), terms.seed);
    rays.push_back({choice.cell, position, gain});
    ++samples;
    for (std::size_t slot = 0; slot < kSlots; ++slot) {
      slots.distance2[slot] =
          std::min(slots.distance2[slot],
                   PlainDistance2(slot, terms.cell_width, position));
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
    const int seen = samples.count(cell);
    const CellChoice choice = {&map.Slots(cell), cell, seen,
                               std::min(most, kMostPerCell - seen)};
    if (choice.most == 0) continue;
    const ChoiceTerms terms = {map.cell_width(), 0, request.seed};
    for (const RayChoice& ray : PlainChooseInCell(choice, terms)) {
      rays.push_back(ray);
    }
  }
  return rays;
}

/// RayChooser: of two a cell, and where a second one gains more than the last
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
