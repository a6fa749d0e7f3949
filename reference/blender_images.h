/// @file
/// The images that a scene names, each in the JSON once.
#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "core/base/result.h"

namespace rtb {

/// Collects images.
class BlenderImages {
 public:
  /// The index of an image of colors, which is read at its first use.
  Result<int> Add(const std::filesystem::path& file);

  /// All images, by index.
  nlohmann::ordered_json Take() { return std::move(images_); }

 private:
  std::map<std::filesystem::path, int> places_;
  nlohmann::ordered_json images_ = nlohmann::ordered_json::array();
};

}  // namespace rtb
