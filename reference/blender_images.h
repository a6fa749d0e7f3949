/// @file
/// The images that a scene names, each in the JSON once.
#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/base/result.h"

namespace rtb {

/// Collects images.
class BlenderImages {
 public:
  /// The index of an image of colors, which is read at its first use.
  Result<int> Add(const std::filesystem::path& file);

  /// The same of a height map, whose values are linear.
  Result<int> AddHeights(const std::filesystem::path& file);

  /// All images, by index.
  nlohmann::ordered_json Take() { return std::move(images_); }

 private:
  /// Whether it is a height map, and the file.
  using Key = std::pair<bool, std::filesystem::path>;

  std::map<Key, int> places_;
  nlohmann::ordered_json images_ = nlohmann::ordered_json::array();
};

}  // namespace rtb
