/// @file
/// BvhAccel: owns the flat hierarchy that BvhTracer walks, builds it from a
/// Geometry and follows what moves.
#pragma once

#include <span>
#include <vector>

#include "core/accel/bvh_builder.h"
#include "core/accel/bvh_kernels.h"
#include "core/accel/bvh_view.h"
#include "core/accel/ray.h"
#include "core/base/result.h"

namespace rtb {

/// A BVH of two levels; see BvhView. Queries are thread-safe and answer what
/// BvhTracer does, bit for bit.
class BvhAccel {
 public:
  /// @param geometry must outlive the accelerator, and may only be changed by
  /// ReplaceMoving before a call of Update.
  /// @param transmittance per object, as EmbreeAccel::Build takes it.
  /// @param threads at most this many build it; 0 = all cores.
  /// @return an Error when memory does not suffice.
  static Result<BvhAccel> Build(Geometry& geometry,
                                std::vector<Rgb> transmittance,
                                int threads = 0);

  /// Follows a change of the geometry's moving part: rebuilds the tree over
  /// what moves. That of what stands still and those of the meshes are not
  /// touched; a mesh that is placed for the first time is appended.
  /// @param transmittance of all objects, as for Build.
  Status Update(std::vector<Rgb> transmittance, int threads = 0);

  /// The closest hit on (0, ray.t_max), kind kNothing if there is none.
  Hit Closest(const Ray& ray) const;
  /// The share of light that passes along the ray.
  Rgb Transmittance(const Ray& ray) const;
  /// Whether anything, transparent or not, lies on (0, ray.t_max).
  bool Occluded(const Ray& ray) const;
  /// The geometry it was built from.
  const GeometryView& geometry() const { return view_.geometry; }

  /// Valid until the next Update, and while the accelerator and the geometry
  /// live (moving the accelerator does not harm it).
  const BvhView& view() const { return view_; }

  /// @name The arrays behind the view, e.g. for a copy on a device.
  /// @{
  /// Never changed after Build.
  const BvhArrays& still() const { return still_; }
  /// Replaced by each Update.
  const BvhArrays& moving() const { return moving_; }
  /// Trees of meshes; Update may append to them, and changes nothing there.
  const BvhArrays& meshes() const { return meshes_; }
  std::span<const BvhRoot> mesh_roots() const { return mesh_roots_; }
  /// One for each object; replaced by each Update.
  std::span<const Rgb> transmittance() const { return transmittance_; }
  /// @}

 private:
  explicit BvhAccel(BvhBuilder builder) : builder_(std::move(builder)) {}

  /// Builds the trees of the meshes that [begin, end) of the uses place, as
  /// far as they are not there.
  Status BuildMeshes(std::size_t begin, std::size_t end, int threads);

  /// The tree over numbers [begin, end) of the geometry's lists.
  Result<BvhRoot> BuildPart(const GeometryCounts& begin,
                            const GeometryCounts& end, int threads,
                            BvhArrays* arrays) const;

  void RenewView();

  BvhBuilder builder_;
  const BvhKernels* kernels_ = &RunnableBvhKernels().back();
  Geometry* geometry_ = nullptr;
  BvhArrays still_, moving_, meshes_;
  BvhRoot still_root_, moving_root_;
  std::vector<BvhRoot> mesh_roots_;
  std::vector<Rgb> transmittance_;
  BvhView view_;
};

}  // namespace rtb
