#include "reference/blender_images.h"

#include <algorithm>

#include "core/image/io.h"
#include "core/shading/texture_load.h"
#include "reference/blender_json.h"

namespace rtb {

Result<int> BlenderImages::Add(const std::filesystem::path& file) {
  const auto next = static_cast<int>(images_.size());
  const auto [place, added] = places_.emplace(Key(false, file), next);
  if (!added) return place->second;
  RTB_ASSIGN_OR_RETURN(const Image image, ReadLinear(file));
  images_.push_back(BlenderImage(image));
  return next;
}

Result<int> BlenderImages::AddHeights(const std::filesystem::path& file) {
  const auto next = static_cast<int>(images_.size());
  const auto [place, added] = places_.emplace(Key(true, file), next);
  if (!added) return place->second;
  RTB_ASSIGN_OR_RETURN(const HeightMap map, LoadHeightMap(file));
  Image image(map.width, map.height);
  std::transform(map.values.begin(), map.values.end(), image.pixels().begin(),
                 [](float height) { return Rgb(height); });
  images_.push_back(BlenderImage(image));
  return next;
}

}  // namespace rtb
