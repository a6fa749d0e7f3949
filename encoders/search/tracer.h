/// @file
/// SearchTracer: the rays of encoder `search` traced, round by round.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/render/fragment_source.h"
#include "encoders/evidence.h"
#include "encoders/search/rays.h"

namespace rtb {

/// All that has been traced of one cell.
struct SearchedCell {
  SearchRays rays;
  std::vector<PlacedRay> placed;
};

/// One strip of one cell, to be traced.
struct StripRequest {
  int cell;
  SearchDirection direction;
  int strip;
};

/// Which rays a tracer traces.
struct SearchPattern {
  GridSize grid;
  double cell_aspect = 0.5;
  int strips = kMaxStrips;  ///< Of each search.
  std::uint64_t seed = 0;   ///< Of the positions along the strips.
  Blend blend = Blend::kSrgb;
};

/// Traces strips and keeps what they show.
class SearchTracer {
 public:
  /// @param source must outlive the tracer.
  SearchTracer(FragmentSource& source, const SearchPattern& pattern);

  /// The given strips of both searches, in every cell.
  Status TraceEverywhere(std::span<const int> strips);

  /// Any strips, none of them traced before; those of one cell in a row.
  Status Trace(const std::vector<StripRequest>& requests);

  const std::vector<SearchedCell>& cells() const { return cells_; }
  double rays_per_cell() const;
  /// Moves out what was seen.
  Evidence TakeEvidence() { return std::move(evidence_); }

 private:
  SamplePlan PlanOf(const std::vector<StripRequest>& requests) const;

  FragmentSource& source_;
  SearchPattern pattern_;
  std::vector<SearchedCell> cells_;
  Evidence evidence_;
};

}  // namespace rtb
