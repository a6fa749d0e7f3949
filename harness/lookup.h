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

/// The committed reference of a scene file that stands in a folder `scenes`:
/// in the folder `reference` beside that.
std::optional<std::filesystem::path> FindReference(
    const std::filesystem::path& scene_file, const std::string& renderer);

/// The folder for new references of a scene file: `reference` beside its
/// folder `scenes`, else the current folder's `reference`.
std::filesystem::path ReferenceFolder(const std::filesystem::path& scene_file);

}  // namespace rtb
