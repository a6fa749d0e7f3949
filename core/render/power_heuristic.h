/// @file
/// How two ways of sampling share what both may find, host and device.
#pragma once

#include "core/base/host_device.h"

namespace rtb {

/// The power heuristic with exponent 2: Veach, "Robust Monte Carlo Methods for
/// Light Transport Simulation", 1997, section 9.2.2.
/// @param a the density that the sample was drawn with, b the other way's at
///     the same place, each times how many samples it has.
/// @return the sample's weight.
RTB_HD inline float PowerHeuristic(float a, float b) {
  if (!(b > 0)) return 1;
  const float ratio = b / a;  // a^2 / (a^2 + b^2) without overflow
  return 1 / (1 + ratio * ratio);
}

}  // namespace rtb
