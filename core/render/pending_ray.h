/// @file
/// What the Whitted integrator keeps of a ray that it has still to trace, host
/// and device.
#pragma once

#include <cstdint>

#include "core/base/host_device.h"
#include "core/shading/interaction.h"

namespace rtb {

/// A ray whose radiance is still to be added, times its weight.
struct PendingRay {
  Ray ray;
  float width;  ///< Of the beam at the ray's origin.
  Rgb weight;
  int depth;
  std::uint32_t branch;  ///< Which of the eye ray's descendants it is, but
                         ///< for siblings in one rough lobe.
  std::uint32_t run;     ///< Among these, and those of the sample's other
                         ///< eye rays: of StratifiedPoints.
  int siblings;          ///< Its share of a rough lobe is 1 / siblings.
  int fan;               ///< So many of them left the last surface.
  float lobe_pdf;        ///< Per solid angle, times `fan`; 0 where no points
                         ///< of lights stand for the ray too.
  bool refracted;
};

/// The ray that leaves `at` as one of its ray's children.
RTB_HD inline PendingRay ChildOf(const PendingRay& from, const Interaction& at,
                                 const V3f& direction, const Rgb& weight,
                                 std::uint32_t child) {
  // Up to 16 children each; the hash of a long line of them may wrap.
  PendingRay next{{},
                  at.cone.width,
                  from.weight * weight,
                  from.depth + 1,
                  from.branch * 16 + child,
                  from.run,
                  from.siblings,
                  1,
                  0,
                  false};
  next.ray.origin = LeavingOrigin(at.point, direction);
  next.ray.direction = direction;
  return next;
}

}  // namespace rtb
