/// @file
/// MipChain: an image at all levels of detail, for textures and bump maps.
#pragma once

#include <vector>

#include "core/image/image.h"
#include "core/shading/texture.h"

namespace rtb {

/// Heights, row by row from the top left.
struct HeightMap {
  int width = 0;
  int height = 0;
  std::vector<float> values;
};

/// A grid of texels and, after it, those of half its size each, down to one
/// texel; each the area average of the one before (Williams, "Pyramidal
/// Parametrics", SIGGRAPH 1983). T is Rgb or float.
template <class T>
struct MipChain {
  int width = 0;
  int height = 0;
  int levels = 0;
  std::vector<T> texels;

  /// A view, which the chain must outlive.
  TexelGrid<T> grid() const { return {width, height, texels.data(), levels}; }
};

/// The levels of an image of at least one pixel.
MipChain<Rgb> MakeMipChain(const Image& image);

/// The levels of a map of at least one height.
MipChain<float> MakeMipChain(const HeightMap& map);

}  // namespace rtb
