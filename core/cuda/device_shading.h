/// @file
/// DeviceShading: a ShadingScene mirrored on the device.
#pragma once

#include <cuda_runtime_api.h>

#include <vector>

#include "core/base/result.h"
#include "core/cuda/device_array.h"
#include "core/shading/shading_scene.h"

namespace rtb {

/// Materials, images and tables are uploaded once; lights whenever the scene
/// moves: they are few, and the choice among them depends on where all are.
class DeviceShading {
 public:
  /// Copies everything.
  Status Upload(const ShadingScene& shading, cudaStream_t stream);
  /// Copies what PlaceLights may have changed since.
  Status Move(const ShadingScene& shading, cudaStream_t stream);

  /// The view in the device's pointers; valid until the next of these calls.
  const ShadingView& view() const { return view_; }

 private:
  Status UploadTextures(const ShadingScene& shading, cudaStream_t stream);
  Status UploadBackground(const ShadingScene& shading, cudaStream_t stream);

  DeviceArray<MaterialData> materials_;
  std::vector<DeviceArray<Rgb>> texture_texels_;
  DeviceArray<ImageTextureData> textures_;
  std::vector<DeviceArray<float>> bump_texels_;
  DeviceArray<BumpData> bumps_;
  DeviceArray<Rgb> environment_texels_;
  DeviceArray<float> row_cdf_;
  DeviceArray<float> column_cdfs_;
  DeviceArray<float> ggx_root_loss_;
  DeviceArray<LightData> lights_;
  DeviceArray<float> light_cdf_;
  DeviceArray<int> triangle_emitters_;
  DeviceArray<int> sphere_emitters_;
  DeviceArray<int> use_emitters_;
  ShadingView view_;
};

}  // namespace rtb
