/// @file
/// BvhKernels: BvhTracer's queries compiled for the instruction sets that
/// there are, chosen at run time.
#pragma once

#include <span>

#include "core/accel/bvh_tracer.h"

namespace rtb {

/// The queries of one instruction set. All give the same bits.
struct BvhKernels {
  const char* name;
  Hit (*closest)(const BvhView&, const Ray&);
  void (*cross)(const BvhView&, const Ray&, BvhCrossing*);

  Hit Closest(const BvhView& view, const Ray& ray) const {
    return closest(view, ray);
  }
  void Cross(const BvhView& view, const Ray& ray, BvhCrossing* crossing) const {
    cross(view, ray, crossing);
  }
};

/// A tracer on the host.
using HostBvhTracer = BvhQueryTracer<BvhKernels>;

/// Those that this machine can run, the portable ones first, the best last.
std::span<const BvhKernels> RunnableBvhKernels();

}  // namespace rtb
