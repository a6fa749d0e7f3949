/// @file
/// Where the next rays are worth most. VoronoiMap -> RayChooser -> SamplePlan.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "encoders/adaptive/found_rays.h"
#include "encoders/adaptive/voronoi_map.h"

namespace rtb {

/// Samples that one cell gets at most.
inline constexpr int kMostPerCell = 64;

/// What the choice of rays depends on.
struct RayRequest {
  int rays = 0;           ///< At most.
  int most_per_cell = 4;  ///< Of these.
  std::uint64_t seed = 0;
  int threads = 0;
};

/// Chooses the rays of one round after the other.
class RayChooser {
 public:
  /// @param map,samples must outlive this.
  RayChooser(const VoronoiMap& map, const SeenSamples& samples);

  /// The rays of the largest expected gains, by rising cells. Fewer than asked
  /// for only where cells have all that they may get, now or at all.
  std::vector<RayChoice> Choose(const RayRequest& request);

 private:
  /// The least gains of the turns, which fall.
  using TurnEnds = std::array<float, kTurns>;

  void CountGains();
  TurnEnds EndsOf(int rays) const;
  void FindCells(const TurnEnds& ends);
  void FindCells(const TurnEnds& ends, FoundRays& part) const;
  void FindRays(std::size_t turn, const RayRequest& request);
  void FindIn(std::size_t turn, const RayRequest& request,
              FoundRays& part) const;
  void FindIn(std::span<const int> cells, const RayRequest& request,
              FoundRays& part) const;
  void RaiseLeast(int rays);

  float Gain(int cell) const {
    return map_.best_gains()[static_cast<std::size_t>(cell)];
  }

  const VoronoiMap& map_;
  const SeenSamples& samples_;
  GainThreshold threshold_;
  float least_ = 0;
  std::vector<FoundRays> parts_;  ///< Kept for the memory.
};

}  // namespace rtb
