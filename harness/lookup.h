/// @file
/// Lookup: where scenes and reference images are found by name.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace rtb {

/// The folders that may hold `scenes/` and `reference/`, best first.
using DataFolders = std::vector<std::filesystem::path>;

/// The data folders of a program: the value of RTBENCH_DATA (empty = unset),
/// share/rtbench beside the program's bin/, the program's own folder, and the
/// nearest folder above it that has both scenes/ and reference/. Only those
/// that exist are named.
DataFolders FindDataFolders(const std::filesystem::path& executable,
                            const std::string& environment);

/// The same for the running program and its environment.
DataFolders FindDataFolders();

/// A scene that lookup knows by name.
struct NamedScene {
  std::string name;
  std::filesystem::path file;
};

/// All scenes of the data folders, sorted by name; of equal names the first
/// folder's.
std::vector<NamedScene> ListScenes(const DataFolders& folders);

/// The file of a scene given by name, or else as a file.
/// @return kBadInput that lists the known names when there is neither.
Result<std::filesystem::path> FindScene(const DataFolders& folders,
                                        const std::string& name_or_file);

/// The file of a scene's reference, there or not: in the folder `reference`
/// beside the scene's folder `scenes`, else in the current folder's
/// `reference`, under the name of ReferencePath.
std::filesystem::path ReferenceFile(const std::filesystem::path& scene_file,
                                    const std::string& renderer, double time,
                                    int seed = 0);

/// The same where it exists.
std::optional<std::filesystem::path> FindReference(
    const std::filesystem::path& scene_file, const std::string& renderer,
    double time);

}  // namespace rtb
