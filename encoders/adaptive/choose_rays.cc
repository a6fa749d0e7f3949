#include "encoders/adaptive/choose_rays.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "core/base/parallel.h"
#include "core/math/random.h"
#include "encoders/adaptive/slot_gains.h"

namespace rtb {
namespace {

constexpr int kGrain = 64;

/// How far from its slot's center a sample may lie, over all that the slot
/// has: the first one near it, which spreads samples evenly, others anywhere.
constexpr float kFirstJitter = 0.5f;
constexpr float kJitter = 1;

/// A sample's Voronoi cell reaches at most this times the distance to the
/// nearest other one, and a little: chosen samples lie where that is large.
constexpr float kReach = 1.5f;
constexpr float kLeastReach = 1;

V2f Jittered(int slot, float jitter, int cell, int number, std::uint64_t seed) {
  const auto pixel = static_cast<std::uint32_t>(cell);
  const auto sample = static_cast<std::uint32_t>(number);
  const V2f unit(UnitFloat(RandomBits(pixel, sample, 0, seed)),
                 UnitFloat(RandomBits(pixel, sample, 1, seed)));
  return SlotCenter(slot) + (unit - V2f(0.5f, 0.5f)) *
                                V2f(jitter / kSlotColumns, jitter / kSlotRows);
}

/// The best rays of one cell, `most` of them, that gain at least `least`.
void ChooseInCell(const VoronoiMap& map, int cell, int seen, int most,
                  float least, std::uint64_t seed,
                  std::vector<RayChoice>& out) {
  SlotGains gains(map, cell);
  const int last = std::min(most, kMostPerCell - seen) - 1;
  for (int i = 0; i <= last; ++i) {
    const int slot = gains.Best();
    const float gain = gains.gain(slot);
    if (gain < least) return;
    const V2f position = Jittered(
        slot, gains.empty(slot) ? kFirstJitter : kJitter, cell, seen + i, seed);
    const float reach = kReach * gains.distance(slot) + kLeastReach;
    out.push_back({cell, position, gain, std::min(reach, kCellHeight)});
    if (i < last) gains.Expect(slot, position);
  }
}

/// The count-th largest value; 0 with fewer.
float Largest(std::vector<float> values, int count) {
  const auto n = static_cast<std::size_t>(count);
  if (n > values.size()) return 0;
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(n) - 1;
  std::nth_element(values.begin(), at, values.end(), std::greater<>());
  return *at;
}

std::vector<float> GainsOf(const std::vector<RayChoice>& rays) {
  std::vector<float> gains(rays.size());
  std::ranges::transform(rays, gains.begin(), &RayChoice::gain);
  return gains;
}

/// All rays that gain at least `least`, `most` a cell.
std::vector<RayChoice> RaysAbove(const VoronoiMap& map,
                                 const SeenSamples& samples, float least,
                                 int most, const RayRequest& request) {
  const int cells = samples.grid().cells();
  std::vector<std::vector<RayChoice>> parts(
      static_cast<std::size_t>((cells + kGrain - 1) / kGrain));
  ParallelFor(cells, kGrain, request.threads, [&](int begin, int end) {
    std::vector<RayChoice>& part =
        parts[static_cast<std::size_t>(begin / kGrain)];
    for (int cell = begin; cell < end; ++cell) {
      const float gain = map.best_gains()[static_cast<std::size_t>(cell)];
      if (gain < least) continue;
      ChooseInCell(map, cell, samples.count(cell), most, least, request.seed,
                   part);
    }
  });
  std::vector<RayChoice> rays;
  for (const auto& part : parts) {
    rays.insert(rays.end(), part.begin(), part.end());
  }
  return rays;
}

/// Whether a cell that got `most` rays may have another one above `least`.
bool WantsMore(const std::vector<RayChoice>& rays, int most, float least) {
  const auto before = static_cast<std::size_t>(most) - 1;
  for (std::size_t i = before; i < rays.size(); ++i) {
    if (rays[i].gain > least && rays[i].cell == rays[i - before].cell) {
      return true;
    }
  }
  return false;
}

/// Keeps the `count` rays of the largest gains, of equal ones the first.
void KeepBest(std::vector<RayChoice>& rays, int count) {
  if (rays.size() <= static_cast<std::size_t>(count)) return;
  const float least = Largest(GainsOf(rays), count);
  auto equal =
      count - std::ranges::count_if(rays, [least](const RayChoice& ray) {
        return ray.gain > least;
      });
  std::erase_if(rays, [&](const RayChoice& ray) {
    return ray.gain < least || (ray.gain == least && equal-- <= 0);
  });
}

}  // namespace

std::vector<RayChoice> ChooseRays(const VoronoiMap& map,
                                  const SeenSamples& samples,
                                  const RayRequest& request) {
  if (request.rays <= 0) return {};
  const std::span<const float> best = map.best_gains();
  // That many cells have a ray that gains this much: none below is wanted.
  float least = Largest({best.begin(), best.end()}, request.rays);
  // Few cells want many rays. It is cheaper to choose two in each cell first,
  // which shows about what the last of the wanted ones gains.
  const int few = std::min(2, request.most_per_cell);
  std::vector<RayChoice> rays = RaysAbove(map, samples, least, few, request);
  least = std::max(least, Largest(GainsOf(rays), request.rays));
  if (WantsMore(rays, few, least)) {
    rays = RaysAbove(map, samples, least, request.most_per_cell, request);
  }
  KeepBest(rays, request.rays);
  return rays;
}

}  // namespace rtb
