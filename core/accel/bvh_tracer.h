/// @file
/// BvhTracer: what integrators ask of a scene, answered by a BvhView, host
/// and device.
#pragma once

#include "core/accel/bvh_query.h"
#include "core/accel/stepped_transmittance.h"
#include "core/base/host_device.h"

namespace rtb {

/// The two queries, compiled for wherever this is.
/// @tparam Lanes the tests of boxes and triangles.
template <class Lanes>
struct LaneQueries {
  RTB_HD Hit Closest(const BvhView& view, const Ray& ray) const {
    return ClosestInBvh<Lanes>(view, ray);
  }
  RTB_HD void Cross(const BvhView& view, const Ray& ray,
                    BvhCrossing* crossing) const {
    CrossBvh<Lanes>(view, ray, crossing);
  }
};

/// Answers ray queries on a BvhView as EmbreeAccel does on its scene. No
/// recursion, no allocation; the stacks are of fixed size, which BvhAccel's
/// trees never exceed.
/// @tparam Queries as LaneQueries; all give the same bits.
template <class Queries>
class BvhQueryTracer {
 public:
  /// @param view must outlive the tracer.
  RTB_HD explicit BvhQueryTracer(const BvhView& view, Queries queries = {})
      : view_(view), queries_(queries) {}

  /// The closest hit on (0, ray.t_max), kind kNothing if there is none.
  RTB_HD Hit Closest(const Ray& ray) const {
    return queries_.Closest(view_, ray);
  }

  /// Whether anything, transparent or not, lies on (0, ray.t_max).
  RTB_HD bool Occluded(const Ray& ray) const {
    BvhCrossing crossing;
    crossing.opaque = true;
    queries_.Cross(view_, ray, &crossing);
    return crossing.blocked;
  }

  /// The share of light that passes along the ray: the product of the
  /// transmittances of all surfaces crossed, 0 when an opaque one is.
  RTB_HD Rgb Transmittance(const Ray& ray) const {
    BvhCrossing crossing;
    queries_.Cross(view_, ray, &crossing);
    if (crossing.blocked) return Rgb(0);
    if (!crossing.crossed) return Rgb(1);
    return SteppedTransmittance(*this, view_.transmittance, ray);
  }

  RTB_HD const GeometryView& geometry() const { return view_.geometry; }

 private:
  const BvhView& view_;
  const Queries queries_;
};

/// A tracer of chosen tests.
template <class Lanes>
using BasicBvhTracer = BvhQueryTracer<LaneQueries<Lanes>>;

/// The tracer of every machine.
using BvhTracer = BasicBvhTracer<PortableLanes>;

}  // namespace rtb
