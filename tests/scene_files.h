/// @file
/// The scenes of a folder, for tests and benchmarks of every one.
#pragma once

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

namespace rtb::testing {

/// The scene files of a folder, sorted.
inline std::vector<std::filesystem::path> SceneFiles(
    const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".yaml") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// Their names.
inline std::vector<std::string> SceneNames(
    const std::filesystem::path& folder) {
  std::vector<std::string> names;
  for (const auto& file : SceneFiles(folder)) {
    names.push_back(file.stem().string());
  }
  return names;
}

}  // namespace rtb::testing
