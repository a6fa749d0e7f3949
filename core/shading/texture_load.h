/// @file
/// Reading the images of textures and bump maps.
#pragma once

#include <filesystem>
#include <string>

#include "core/base/result.h"
#include "core/image/image.h"
#include "core/shading/bump.h"
#include "core/shading/mip_chain.h"
#include "core/shading/texture.h"

namespace rtb {

/// What the texels of an image may be.
struct TexelRange {
  float low;
  float high;
  std::string what;  ///< "a radiance": what the numbers mean.
};

/// An Error that names the file and the first pixel, if any, with a component
/// outside the range or no finite number.
Status CheckTexels(const Image& image, const std::filesystem::path& file,
                   const TexelRange& range);

/// Reads an image of albedos in [0, 1], scene-linear: integer codes are
/// sRGB-encoded, floats are linear. An Error names the file.
Result<Image> LoadTexture(const std::filesystem::path& file);

/// The texture that shows an image, whose levels must outlive it.
ImageTextureData TextureOf(const MipChain<Rgb>& image, const V2f& scale);

/// Reads a height map: integer codes over the largest code, floats as they
/// are; the mean of the components where the image has color. An Error names
/// the file.
Result<HeightMap> LoadHeightMap(const std::filesystem::path& file);

/// The bump map of a height map, whose levels must outlive it.
/// @param amount height of value 1 in scene units.
BumpData BumpOf(const MipChain<float>& map, const V2f& scale, float amount);

}  // namespace rtb
