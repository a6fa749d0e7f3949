#include "harness/lookup.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <system_error>

#include "core/base/suggest.h"
#include "reference/reference.h"

namespace rtb {
namespace {

namespace fs = std::filesystem;

bool IsFolder(const fs::path& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

bool Exists(const fs::path& path) {
  std::error_code ignored;
  return fs::exists(path, ignored) && !fs::is_directory(path, ignored);
}

/// The nearest folder above `start` that looks like the repository.
std::optional<fs::path> Repository(fs::path start) {
  while (true) {
    if (IsFolder(start / "scenes") && IsFolder(start / "reference")) {
      return start;
    }
    if (start == start.parent_path()) return std::nullopt;
    start = start.parent_path();
  }
}

/// Says which scenes there are.
Error SceneError(const std::string& what, const std::string& given,
                 const std::vector<NamedScene>& scenes) {
  std::vector<std::string> names;
  for (const NamedScene& scene : scenes) names.push_back(scene.name);
  if (names.empty()) {
    return BadInput("--scene", what,
                    "no scene folder was found: set RTBENCH_DATA to a folder "
                    "that holds scenes/");
  }
  return BadInput("--scene", what + "; the scenes are " + JoinNames(names),
                  DidYouMean(given, names));
}

fs::path ReferenceFolder(const fs::path& scene_file) {
  std::error_code ignored;
  const fs::path folder = fs::absolute(scene_file, ignored).parent_path();
  if (folder.filename() == "scenes") return folder.parent_path() / "reference";
  return "reference";
}

}  // namespace

DataFolders FindDataFolders(const fs::path& executable,
                            const std::string& environment) {
  const fs::path folder = executable.parent_path();
  DataFolders folders;
  const auto add = [&folders](const fs::path& candidate) {
    const fs::path path = candidate.lexically_normal();
    const bool known =
        std::find(folders.begin(), folders.end(), path) != folders.end();
    if (!known && IsFolder(path / "scenes")) folders.push_back(path);
  };
  if (!environment.empty()) add(environment);
  add(folder.parent_path() / "share" / "rtbench");
  add(folder);
  if (const auto repository = Repository(folder)) add(*repository);
  return folders;
}

DataFolders FindDataFolders() {
  std::error_code ignored;
  const char* environment = std::getenv("RTBENCH_DATA");
  return FindDataFolders(fs::read_symlink("/proc/self/exe", ignored),
                         environment != nullptr ? environment : "");
}

std::vector<NamedScene> ListScenes(const DataFolders& folders) {
  std::map<std::string, fs::path> found;
  for (const fs::path& folder : folders) {
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(folder / "scenes", error)) {
      const fs::path& file = entry.path();
      if (file.extension() != ".yaml" || !Exists(file)) continue;
      found.emplace(file.stem().string(), file);
    }
  }
  std::vector<NamedScene> scenes;
  for (const auto& [name, file] : found) scenes.push_back({name, file});
  return scenes;
}

Result<fs::path> FindScene(const DataFolders& folders,
                           const std::string& name_or_file) {
  const std::vector<NamedScene> scenes = ListScenes(folders);
  if (name_or_file.empty()) {
    return Fail(SceneError("no scene is given", "", scenes));
  }
  for (const NamedScene& scene : scenes) {
    if (scene.name == name_or_file) return scene.file;
  }
  if (Exists(name_or_file)) return fs::path(name_or_file);
  return Fail(SceneError("found '" + name_or_file +
                             "', which is neither a scene's name nor a file",
                         name_or_file, scenes));
}

fs::path ReferenceFile(const fs::path& scene_file, const std::string& renderer,
                       double time, int seed) {
  return ReferencePath(ReferenceFolder(scene_file), scene_file.stem().string(),
                       renderer, time, seed);
}

std::optional<fs::path> FindReference(const fs::path& scene_file,
                                      const std::string& renderer,
                                      double time) {
  const fs::path file = ReferenceFile(scene_file, renderer, time);
  if (Exists(file)) return file;
  return std::nullopt;
}

}  // namespace rtb
