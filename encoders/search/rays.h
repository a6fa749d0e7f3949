/// @file
/// Which rays encoder `search` traces, and in which order.
#pragma once

#include <cstdint>

#include "encoders/evidence.h"
#include "encoders/search/split.h"

namespace rtb {

/// Both searches of one cell.
struct SearchRays {
  StripRays vertical;
  StripRays horizontal;

  /// No strip traced.
  explicit SearchRays(int strips)
      : vertical(SearchDirection::kVertical, strips),
        horizontal(SearchDirection::kHorizontal, strips) {}

  StripRays& of(SearchDirection direction) {
    return direction == SearchDirection::kVertical ? vertical : horizontal;
  }
  const StripRays& of(SearchDirection direction) const {
    return direction == SearchDirection::kVertical ? vertical : horizontal;
  }
};

/// The strip that the sequential order traces third: the 4th of 8.
inline int MiddleStrip(int strips) { return strips / 2 - 1; }

/// Where the ray of one strip runs: in the middle of the strip, and at random
/// along it. Depends on nothing but its arguments.
V2f StripPosition(SearchDirection direction, int strips, int cell, int strip,
                  std::uint64_t seed);

/// A bisection: the strip to trace next, between the two neighbors that
/// differ most. At first all traced strips are neighbors, later only those
/// around the last one.
class Bisection {
 public:
  /// @param rays with the first, the last and one more strip traced.
  explicit Bisection(const StripRays& rays);

  /// The strip to trace next; -1 when the neighbors are adjacent.
  int Next() const { return high_ - low_ > 1 ? (low_ + high_) / 2 : -1; }
  /// Goes on after Next() has been traced.
  void Narrow(const StripRays& rays);
  /// Strips before the edge, once Next() is -1.
  int edge() const { return high_; }

 private:
  /// Takes the half around `middle` whose ends differ more; the first of
  /// equal ones.
  void Choose(const StripRays& rays, int middle);

  int low_;
  int high_;
};

}  // namespace rtb
