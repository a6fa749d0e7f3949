/// @file
/// BvhKernels: BvhTracer's answers compiled for the instruction sets that
/// there are, chosen at run time.
#pragma once

#include <span>

#include "core/accel/bvh_view.h"
#include "core/accel/ray.h"

namespace rtb {

/// The queries of one instruction set. All give the same bits.
struct BvhKernels {
  const char* name;
  Hit (*closest)(const BvhView&, const Ray&);
  bool (*occluded)(const BvhView&, const Ray&);
  Rgb (*transmittance)(const BvhView&, const Ray&);
};

/// Those that this machine can run, the portable ones first, the best last.
std::span<const BvhKernels> RunnableBvhKernels();

}  // namespace rtb
