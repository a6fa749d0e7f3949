#include "core/shading/texture_load.h"

#include <limits>
#include <sstream>

#include "core/image/io.h"

namespace rtb {
namespace {

bool IsWithin(const Rgb& texel, const TexelRange& range) {
  for (const float value : {texel.x, texel.y, texel.z}) {
    if (!(value >= range.low && value <= range.high)) return false;
  }
  return true;
}

/// `0 .. 1`, `of 0 or more`: the numbers that a range accepts.
std::string Expected(const TexelRange& range) {
  constexpr float kMost = std::numeric_limits<float>::max();
  std::ostringstream text;
  text << "expected finite numbers";
  if (range.low > -kMost) text << " >= " << range.low;
  if (range.high < kMost) text << " and <= " << range.high;
  return text.str();
}

}  // namespace

Status CheckTexels(const Image& image, const std::filesystem::path& file,
                   const TexelRange& range) {
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const Rgb& texel = image.at(x, y);
      if (IsWithin(texel, range)) continue;
      std::ostringstream what;
      what << "has " << range.what << " of " << texel << " in column " << x
           << ", row " << y << "; " << Expected(range);
      return Fail(BadInput(file.string(), what.str()));
    }
  }
  return {};
}

Result<Image> LoadTexture(const std::filesystem::path& file) {
  RTB_ASSIGN_OR_RETURN(Image image, ReadLinear(file));
  RTB_RETURN_IF_ERROR(CheckTexels(image, file, {0, 1, "an albedo"}));
  return image;
}

ImageTextureData TextureOf(const MipChain<Rgb>& image, const V2f& scale) {
  return {image.grid(), scale};
}

Result<HeightMap> LoadHeightMap(const std::filesystem::path& file) {
  RTB_ASSIGN_OR_RETURN(const Image image, ReadValues(file));
  constexpr float kMost = std::numeric_limits<float>::max();
  RTB_RETURN_IF_ERROR(CheckTexels(image, file, {-kMost, kMost, "a height"}));
  HeightMap map{image.width(), image.height(), {}};
  map.values.reserve(image.pixels().size());
  for (const Rgb& texel : image.pixels()) {
    // In double precision, so that the mean of equal numbers is that number.
    const V3d t(texel);
    map.values.push_back(static_cast<float>((t.x + t.y + t.z) / 3));
  }
  return map;
}

BumpData BumpOf(const MipChain<float>& map, const V2f& scale, float amount) {
  return {map.grid(), scale, amount};
}

}  // namespace rtb
