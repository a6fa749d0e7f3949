/// @file
/// Splits of a cell by one straight edge, as encoder `search` tries them.
#pragma once

#include <array>
#include <span>

#include "core/math/vec.h"
#include "encoders/blend.h"
#include "encoders/cell.h"

namespace rtb {

/// Which way a search runs.
enum class SearchDirection {
  kVertical,    ///< Down the rows: an edge from left to right.
  kHorizontal,  ///< Along the columns: an edge from top to bottom.
};

/// In the order of their values.
inline constexpr std::array kDirections = {SearchDirection::kVertical,
                                           SearchDirection::kHorizontal};

/// Most strips of a search.
inline constexpr int kMaxStrips = 8;

/// The rays of one search: one in each strip (row or column) that was traced.
struct StripRays {
  SearchDirection direction = SearchDirection::kVertical;
  int strips = kMaxStrips;  ///< 8, 6 or 4.
  unsigned traced = 0;      ///< Bit i: strip i was, counted from top or left.
  std::array<V3d, kMaxStrips> colors;  ///< In the blend space.

  StripRays(SearchDirection way, int count) : direction(way), strips(count) {
    colors.fill(V3d(0));
  }
  void Set(int strip, const V3d& color) {
    traced |= 1u << strip;
    colors[static_cast<std::size_t>(strip)] = color;
  }
  bool Has(int strip) const { return (traced >> strip & 1) != 0; }
};

/// Two sides of an edge.
struct EdgeSplit {
  SearchDirection direction = SearchDirection::kVertical;
  int eighths = 4;      ///< From the top or left to the edge, 1..7.
  double strength = 0;  ///< What the split takes off the mean squared error.
  V3d first{0};         ///< Mean above, or to the left.
  V3d second{0};        ///< Mean below, or to the right.
};

/// The edge after the first `k` strips (1..strips-1), at the nearest eighth.
/// Its strength is the squared distance of the sides' means times
/// k (strips - k) / strips^2. Each side needs a traced strip.
EdgeSplit SplitAfter(const StripRays& rays, int k);

/// The strongest of all splits; of equal ones the first.
EdgeSplit StrongestSplit(const StripRays& rays);

/// A ray anywhere in the cell.
struct PlacedRay {
  V2f position;
  V3d color;  ///< In the blend space.
};

/// Of the edges at all eighths in both directions the one that leaves the
/// least squared error around the sides' means; vertical searches and then
/// lower eighths win ties.
EdgeSplit StrongestSplit(std::span<const PlacedRay> rays);

/// Whether `split` is stronger than `best`, noise of its samples aside.
bool IsStronger(const EdgeSplit& split, const EdgeSplit& best);

/// The eighth block that fills the lower or left side.
Cell CellOfSplit(Blend blend, const EdgeSplit& split);

}  // namespace rtb
