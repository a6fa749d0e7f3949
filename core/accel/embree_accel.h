/// @file
/// EmbreeAccel: closest hits and shadow transmittance through Embree. The
/// only header behind which rtc calls are made.
#pragma once

#include <memory>
#include <vector>

#include "core/accel/geometry.h"
#include "core/accel/ray.h"
#include "core/base/result.h"

namespace rtb {

struct EmbreeQuery;

/// Answers ray queries on a Geometry. Triangles are traversed in Embree's
/// robust (watertight at edges) mode, each mesh is built once and placed by
/// instances, spheres and disks are user geometry with the analytic
/// intersections of intersect.h, planes are tested apart. What moves is kept
/// apart from what stands still. Queries are thread-safe.
class EmbreeAccel {
 public:
  /// @param geometry must outlive the accelerator, and may only be changed by
  /// ReplaceMoving before a call of Update.
  /// @param transmittance per object: what share of light passes straight
  /// through its surface at one crossing; 0 = opaque.
  /// @param threads at most this many build it; 0 = all cores.
  /// @return an Error when memory does not suffice.
  static Result<EmbreeAccel> Build(Geometry& geometry,
                                   std::vector<Rgb> transmittance,
                                   int threads = 0);

  /// Follows a change of the geometry's moving part: transforms of placed
  /// meshes and the vertices of other shapes. What stands still and the
  /// meshes' own structures are not touched.
  /// @param transmittance of all objects, as for Build.
  Status Update(std::vector<Rgb> transmittance, int threads = 0);

  EmbreeAccel(EmbreeAccel&&) noexcept;
  EmbreeAccel& operator=(EmbreeAccel&&) noexcept;
  ~EmbreeAccel();

  /// The closest hit on (0, ray.t_max), kind kNothing if there is none.
  Hit Closest(const Ray& ray) const;

  /// The share of light that passes along the ray: the product of the
  /// transmittances of all surfaces crossed, 0 when an opaque one is.
  Rgb Transmittance(const Ray& ray) const;

  /// Whether anything, transparent or not, lies on (0, ray.t_max).
  bool Occluded(const Ray& ray) const;

  /// The geometry it was built from.
  const GeometryView& geometry() const;

  /// The same with the sizes of its lists.
  const Geometry& whole_geometry() const;

  /// What is behind the pointer; known to embree_accel.cc and callbacks.
  struct Impl;

 private:
  /// Whether something opaque lies on the ray; notes what else does.
  bool Blocked(const Ray& ray, EmbreeQuery* query) const;

  explicit EmbreeAccel(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace rtb
