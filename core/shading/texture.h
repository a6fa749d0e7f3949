/// @file
/// Bilinear lookup in images, host and device, and image textures, averaged
/// over what a ray sees of them.
#pragma once

#include <cmath>
#include <cstddef>

#include "core/base/host_device.h"
#include "core/math/vec.h"
#include "core/shading/texture_taps.h"

namespace rtb {

/// Texels row by row from the top left; texel (i, j) has its center at
/// (i + 0.5, j + 0.5). T is Rgb or float.
template <class T>
struct TexelGrid {
  int width = 0;
  int height = 0;
  const T* texels = nullptr;
  /// This grid and those of half the size each that follow it (MipChain).
  int levels = 1;

  RTB_HD const T& at(int x, int y) const {
    return texels[static_cast<std::size_t>(y) *
                      static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(x)];
  }
};

/// The size of the grid after one of that size, along one axis.
RTB_HD inline int HalfSize(int size) { return size > 1 ? size / 2 : 1; }

/// A level of a grid, 0 the grid itself.
template <class T>
RTB_HD TexelGrid<T> LevelOf(TexelGrid<T> grid, int level) {
  for (; level > 0; --level) {
    grid.texels += static_cast<std::size_t>(grid.width) *
                   static_cast<std::size_t>(grid.height);
    grid.width = HalfSize(grid.width);
    grid.height = HalfSize(grid.height);
    --grid.levels;
  }
  return grid;
}

/// Texels of a grid and of the levels after it.
template <class T>
std::size_t TexelsOfAllLevels(const TexelGrid<T>& grid) {
  return static_cast<std::size_t>(LevelOf(grid, grid.levels).texels -
                                  grid.texels);
}

/// How a grid goes on past its edges.
enum class EdgeRule { kWrap, kClamp };

/// The index in [0, size) that stands for any index.
RTB_HD inline int TexelIndex(int i, int size, EdgeRule rule) {
  if (rule == EdgeRule::kClamp) return i < 0 ? 0 : (i < size ? i : size - 1);
  const int rest = i % size;
  return rest < 0 ? rest + size : rest;
}

/// The value at a position in texels, x to the right and y downwards,
/// interpolated between the four nearest centers. Wraps horizontally.
template <class T>
RTB_HD T Bilinear(const TexelGrid<T>& grid, float x, float y,
                  EdgeRule vertical) {
  const float left = std::floor(x - 0.5f);
  const float top = std::floor(y - 0.5f);
  const float fx = x - 0.5f - left;
  const float fy = y - 0.5f - top;
  const int i = static_cast<int>(left);
  const int j = static_cast<int>(top);
  const int i0 = TexelIndex(i, grid.width, EdgeRule::kWrap);
  const int i1 = TexelIndex(i + 1, grid.width, EdgeRule::kWrap);
  const int j0 = TexelIndex(j, grid.height, vertical);
  const int j1 = TexelIndex(j + 1, grid.height, vertical);
  const T upper = grid.at(i0, j0) * (1 - fx) + grid.at(i1, j0) * fx;
  const T lower = grid.at(i0, j1) * (1 - fx) + grid.at(i1, j1) * fx;
  return upper * (1 - fy) + lower * fy;
}

/// The part of a number after the point, in [0, 1); 0 where there is none.
RTB_HD inline float Fraction(float value) {
  const float fraction = value - std::floor(value);
  return fraction >= 0 && fraction < 1 ? fraction : 0;
}

/// Where texture coordinates lie in a grid that repeats, in texels: u runs to
/// the right and v upwards, v = 0 is the bottom edge.
/// @param scale multiplies uv.
template <class T>
RTB_HD V2f TexelPosition(const TexelGrid<T>& grid, const V2f& uv,
                         const V2f& scale) {
  return {Fraction(uv.x * scale.x) * static_cast<float>(grid.width),
          (1 - Fraction(uv.y * scale.y)) * static_cast<float>(grid.height)};
}

/// Texels per unit of u and v.
template <class T>
RTB_HD V2f TexelsPerUv(const TexelGrid<T>& grid, const V2f& scale) {
  return {scale.x * static_cast<float>(grid.width),
          scale.y * static_cast<float>(grid.height)};
}

/// An image texture: scene-linear texels, repeated in both directions.
struct ImageTextureData : TexelGrid<Rgb> {
  V2f scale{1, 1};  ///< Multiplies (u, v).
};

/// The texture's color at (u, v), averaged over a footprint around it; a
/// footprint of no size is the point.
RTB_HD_CALLED inline Rgb TextureColor(const ImageTextureData& texture,
                                      const V2f& uv,
                                      const UvFootprint& footprint = {}) {
  const V2f texels = TexelsPerUv(texture, texture.scale);
  const TextureTaps taps = MakeTextureTaps(footprint, texels, texture.levels);
  return MeanOfTaps<Rgb>(taps, uv, [&](int level, const V2f& at) {
    const TexelGrid<Rgb> grid = LevelOf<Rgb>(texture, level);
    const V2f p = TexelPosition(grid, at, texture.scale);
    return Bilinear(grid, p.x, p.y, EdgeRule::kWrap);
  });
}

}  // namespace rtb
