#include "core/shading/mip_chain.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "core/image/resample.h"

namespace rtb {
namespace {

/// @param texel makes a T of an Rgb.
template <class T, class Texel>
MipChain<T> AllLevels(Image level, const Texel& texel) {
  MipChain<T> chain{level.width(), level.height(), 0, {}};
  while (true) {
    std::ranges::transform(level.pixels(), std::back_inserter(chain.texels),
                           texel);
    ++chain.levels;
    if (level.width() == 1 && level.height() == 1) return chain;
    level =
        ResizeArea(level, HalfSize(level.width()), HalfSize(level.height()));
  }
}

}  // namespace

MipChain<Rgb> MakeMipChain(const Image& image) {
  return AllLevels<Rgb>(image, [](const Rgb& color) { return color; });
}

MipChain<float> MakeMipChain(const HeightMap& map) {
  Image image(map.width, map.height);
  std::ranges::transform(map.values, image.pixels().begin(),
                         [](float height) { return Rgb(height); });
  return AllLevels<float>(std::move(image),
                          [](const Rgb& height) { return height.x; });
}

}  // namespace rtb
