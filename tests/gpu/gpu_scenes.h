// The canonical scenes, for what runs on a GPU.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tests/scene_files.h"

namespace rtb::testing {

inline std::filesystem::path CanonicalScene(const std::string& name) {
  return std::filesystem::path(RTB_TEST_SOURCE_DIR) / "scenes" /
         (name + ".yaml");
}

/// Their names, in order.
inline std::vector<std::string> CanonicalScenes() {
  return SceneNames(CanonicalScene("any").parent_path());
}

}  // namespace rtb::testing
