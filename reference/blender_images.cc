#include "reference/blender_images.h"

#include "core/image/io.h"
#include "reference/blender_json.h"

namespace rtb {

Result<int> BlenderImages::Add(const std::filesystem::path& file) {
  const auto next = static_cast<int>(images_.size());
  const auto [place, added] = places_.emplace(file, next);
  if (!added) return place->second;
  RTB_ASSIGN_OR_RETURN(const Image image, ReadLinear(file));
  images_.push_back(BlenderImage(image));
  return next;
}

}  // namespace rtb
