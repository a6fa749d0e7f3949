/// @file
/// Reading the images of textures and bump maps.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/image/image.h"
#include "core/shading/bump.h"
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

/// The texture that shows an image, which must outlive it.
ImageTextureData TextureOf(const Image& image, const V2f& scale);

/// Heights, row by row from the top left.
struct HeightMap {
  int width = 0;
  int height = 0;
  std::vector<float> values;
};

/// Reads a height map: integer codes over the largest code, floats as they
/// are; the mean of the components where the image has color. An Error names
/// the file.
Result<HeightMap> LoadHeightMap(const std::filesystem::path& file);

/// The bump map of a height map, which must outlive it.
/// @param amount height of value 1 in scene units.
BumpData BumpOf(const HeightMap& map, const V2f& scale, float amount);

}  // namespace rtb
