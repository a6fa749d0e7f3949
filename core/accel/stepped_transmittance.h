/// @file
/// Light through transparent surfaces, for every accelerator.
#pragma once

#include <cstddef>

#include "core/accel/surface.h"
#include "core/base/host_device.h"

namespace rtb {

/// The transmittance from surface to surface, each crossed once (a search in
/// any order would count both triangles where a ray meets their common edge).
/// Each step moves the ray's start a little, so that at last it may meet a
/// surface past its end or beside it, such as the light's own: the caller has
/// found nothing opaque on the ray as it was, so that none of these counts.
/// @tparam Tracer answers Closest(ray) and geometry().
/// @param transmittance per object.
template <class Tracer>
RTB_HD Rgb SteppedTransmittance(const Tracer& tracer, const Rgb* transmittance,
                                Ray ray) {
  Rgb left(1);
  while (left != Rgb(0) && ray.t_max > 0) {
    const Hit hit = tracer.Closest(ray);
    if (hit.kind == PrimitiveKind::kNothing) break;
    const SurfacePoint point = SurfaceAt(tracer.geometry(), ray, hit);
    const Rgb& through = transmittance[static_cast<std::size_t>(point.object)];
    if (through != Rgb(0)) left *= through;
    ray.origin = LeavingOrigin(point, ray.direction);
    ray.t_max -= hit.t;
  }
  return left;
}

}  // namespace rtb
