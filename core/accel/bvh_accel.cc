#include "core/accel/bvh_accel.h"

#include <cmath>
#include <type_traits>

#include "core/accel/bvh_boxes.h"
#include "core/base/check.h"

namespace rtb {

static_assert(std::is_trivially_copyable_v<BvhView>);

Result<BvhAccel> BvhAccel::Build(Geometry& geometry,
                                 std::vector<Rgb> transmittance, int threads) {
  RTB_ASSIGN_OR_RETURN(BvhBuilder builder, BvhBuilder::Make());
  BvhAccel accel(std::move(builder));
  accel.geometry_ = &geometry;
  const GeometryCounts& still = geometry.still;
  RTB_RETURN_IF_ERROR(accel.BuildMeshes(0, still.uses, threads));
  RTB_ASSIGN_OR_RETURN(accel.still_root_,
                       accel.BuildPart({}, still, threads, &accel.still_));
  RTB_RETURN_IF_ERROR(accel.Update(std::move(transmittance), threads));
  return accel;
}

Status BvhAccel::Update(std::vector<Rgb> transmittance, int threads) {
  RTB_CHECK_EQ(transmittance.size(), geometry_->objects.size());
  transmittance_ = std::move(transmittance);
  const GeometryCounts& still = geometry_->still;
  const GeometryCounts all = geometry_->counts();
  RTB_RETURN_IF_ERROR(BuildMeshes(still.uses, all.uses, threads));
  moving_.nodes.clear();
  moving_.packs.clear();
  RTB_ASSIGN_OR_RETURN(moving_root_, BuildPart(still, all, threads, &moving_));
  RenewView();
  return {};
}

Status BvhAccel::BuildMeshes(std::size_t begin, std::size_t end, int threads) {
  mesh_roots_.resize(geometry_->meshes.size());
  for (std::size_t i = begin; i < end; ++i) {
    const auto index = static_cast<std::size_t>(geometry_->uses[i].mesh);
    BvhRoot& root = mesh_roots_[index];
    if (root.ref.kind() != BvhKind::kNothing) continue;
    const MeshData& mesh = geometry_->meshes[index];
    RTB_ASSIGN_OR_RETURN(root, builder_.Build(MeshBoxes(mesh), CornersOf(mesh),
                                              threads, &meshes_));
  }
  return {};
}

Result<BvhRoot> BvhAccel::BuildPart(const GeometryCounts& begin,
                                    const GeometryCounts& end, int threads,
                                    BvhArrays* arrays) const {
  return builder_.Build(
      PartBoxes(*geometry_, mesh_roots_, meshes_.nodes, begin, end),
      CornersOf(*geometry_), threads, arrays);
}

void BvhAccel::RenewView() {
  view_ = {still_.tables(),    moving_.tables(),     meshes_.tables(),
           still_root_,        moving_root_,         mesh_roots_.data(),
           ViewOf(*geometry_), transmittance_.data()};
}

Hit BvhAccel::Closest(const Ray& ray) const {
  return HostBvhTracer(view_, *kernels_).Closest(ray);
}

Rgb BvhAccel::Transmittance(const Ray& ray) const {
  return HostBvhTracer(view_, *kernels_).Transmittance(ray);
}

bool BvhAccel::Occluded(const Ray& ray) const {
  return HostBvhTracer(view_, *kernels_).Occluded(ray);
}

}  // namespace rtb
