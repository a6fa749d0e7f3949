#include "core/cuda/device_shading.h"

#include <cstddef>
#include <span>

namespace rtb {
namespace {

/// Copies the texels of many grids, and the grids with the copies' addresses.
/// @tparam Grid a TexelGrid<T>.
template <class Grid, class T>
Status UploadGrids(const std::vector<Grid>& grids,
                   std::vector<DeviceArray<T>>* texels,
                   DeviceArray<Grid>* device, cudaStream_t stream) {
  std::vector<Grid> placed = grids;
  texels->resize(grids.size());
  for (std::size_t i = 0; i < grids.size(); ++i) {
    const std::size_t count = TexelsOfAllLevels(grids[i]);
    RTB_RETURN_IF_ERROR((*texels)[i].Upload(
        std::span<const T>(grids[i].texels, count), stream));
    placed[i].texels = (*texels)[i].data();
  }
  RTB_RETURN_IF_ERROR(device->Upload(std::span<const Grid>(placed), stream));
  return FinishUploads(stream);  // `placed` ends here
}

/// The device's list where the host has one; the views say by a null pointer
/// that there is none.
template <class T>
const T* PointerLike(const T* host, const DeviceArray<T>& device) {
  return host == nullptr ? nullptr : device.data();
}

}  // namespace

Status DeviceShading::Upload(const ShadingScene& shading, cudaStream_t stream) {
  RTB_RETURN_IF_ERROR(materials_.Upload(std::span(shading.materials), stream));
  RTB_RETURN_IF_ERROR(UploadTextures(shading, stream));
  RTB_RETURN_IF_ERROR(UploadBackground(shading, stream));
  RTB_RETURN_IF_ERROR(
      ggx_root_loss_.Upload(std::span(shading.ggx_energy.root_loss), stream));
  return Move(shading, stream);
}

Status DeviceShading::Move(const ShadingScene& shading, cudaStream_t stream) {
  const EmitterIndices& emitters = shading.emitters;
  RTB_RETURN_IF_ERROR(lights_.Upload(std::span(shading.lights), stream));
  RTB_RETURN_IF_ERROR(light_cdf_.Upload(std::span(shading.light_cdf), stream));
  RTB_RETURN_IF_ERROR(
      triangle_emitters_.Upload(std::span(emitters.triangles), stream));
  RTB_RETURN_IF_ERROR(
      sphere_emitters_.Upload(std::span(emitters.spheres), stream));
  RTB_RETURN_IF_ERROR(use_emitters_.Upload(std::span(emitters.uses), stream));
  const ShadingView host = ViewOf(shading);
  view_ = host;  // counts and colors; every pointer is replaced
  view_.materials = materials_.data();
  view_.lights = lights_.data();
  view_.textures = textures_.data();
  view_.bumps = bumps_.data();
  view_.ggx_energy.root_loss =
      PointerLike(host.ggx_energy.root_loss, ggx_root_loss_);
  view_.light_cdf = light_cdf_.data();
  view_.triangle_emitters =
      PointerLike(host.triangle_emitters, triangle_emitters_);
  view_.sphere_emitters = PointerLike(host.sphere_emitters, sphere_emitters_);
  view_.use_emitters = PointerLike(host.use_emitters, use_emitters_);
  EnvironmentData& image = view_.background.image;
  image.texels = PointerLike(image.texels, environment_texels_);
  image.row_cdf = PointerLike(image.row_cdf, row_cdf_);
  image.column_cdfs = PointerLike(image.column_cdfs, column_cdfs_);
  return {};
}

Status DeviceShading::UploadTextures(const ShadingScene& shading,
                                     cudaStream_t stream) {
  RTB_RETURN_IF_ERROR(
      UploadGrids(shading.textures, &texture_texels_, &textures_, stream));
  return UploadGrids(shading.bumps, &bump_texels_, &bumps_, stream);
}

Status DeviceShading::UploadBackground(const ShadingScene& shading,
                                       cudaStream_t stream) {
  const Environment& environment = shading.environment;
  RTB_RETURN_IF_ERROR(
      environment_texels_.Upload(environment.image.pixels(), stream));
  RTB_RETURN_IF_ERROR(row_cdf_.Upload(std::span(environment.row_cdf), stream));
  return column_cdfs_.Upload(std::span(environment.column_cdfs), stream);
}

}  // namespace rtb
