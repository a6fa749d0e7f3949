/// @file
/// The file as a whole, and what its sections share.
#include <array>
#include <system_error>

#include "core/base/suggest.h"
#include "core/scene/scene_reader.h"

namespace rtb {
namespace {

/// "known ids are a, b, c", cut off when there are many; a near one first.
std::string KnownIds(std::string_view word, const IdMap& ids) {
  constexpr std::size_t kMostCompared = 1000;
  constexpr std::size_t kMostListed = 12;
  std::vector<std::string> names;
  for (const auto& [id, index] : ids) {
    if (names.size() < kMostCompared) names.push_back(id);
  }
  if (names.empty()) return "the file defines none";
  const std::string near = DidYouMean(word, names);
  if (!near.empty()) return near;
  const bool all = names.size() <= kMostListed;
  if (!all) names.resize(kMostListed);
  return "known are " + JoinNames(names) + (all ? "" : ", ...");
}

}  // namespace

void SceneReader::Read(YamlNode node) {
  MapReader root(node, "a scene file", context_);
  root.Integer("rtbench_scene", 1, 1);
  scene_.name = root.Name("name");
  scene_.description = root.Text("description", "");
  ReadPaths(root);
  ReadMaterials(root);
  ReadCamera(root);
  ReadBackground(root);
  ReadSettings(root);
  ReadLights(root);
  ReadObjects(root);
  root.Finish();
}

std::vector<YamlNode> SceneReader::Section(MapReader& root,
                                           std::string_view key) {
  const auto list = root.Find(key);
  if (!list) return {};
  return ItemsOf(*list, key, 0, kNoLimit, context_);
}

Index SceneReader::Reference(MapReader& reader, std::string_view key,
                             const IdMap& ids) {
  const std::string id = reader.Name(key, "");
  if (id.empty() || !context_.ok()) return kNone;
  const auto found = ids.find(id);
  if (found != ids.end()) return found->second;
  context_.Fail(reader.MarkOf(key),
                "`" + std::string(key) + "` names `" + id.substr(0, 64) +
                    "`, which is not defined",
                KnownIds(id, ids));
  return kNone;
}

void SceneReader::AddId(MapReader& reader, const std::string& id, Index index,
                        IdMap* ids) {
  if (id.empty() || !context_.ok()) return;
  if (ids->emplace(id, index).second) return;
  context_.Fail(
      reader.MarkOf("id"),
      "the id `" + id.substr(0, 64) + "` is in use already, expected a new one",
      "ids are unique among materials, lights, objects and paths, "
      "each list for itself");
}

std::filesystem::path SceneReader::File(MapReader& reader) {
  const std::string name = reader.Text("file");
  if (!context_.ok() || name.empty()) return {};
  const std::filesystem::path file = scene_.file.parent_path() / name;
  if (known_files_.contains(file)) return file;
  std::error_code error;
  if (std::filesystem::is_regular_file(file, error)) {
    known_files_.insert(file);
    return file;
  }
  const bool there = std::filesystem::exists(file, error);
  context_.Fail(
      reader.MarkOf("file"),
      "`file` names " + file.string() +
          (there ? ", which is not a regular file" : ", which does not exist"),
      "file names are relative to the scene file");
  return {};
}

void SceneReader::ReadBackground(MapReader& root) {
  static const std::array<std::string, 3> kTypes = {"constant", "gradient",
                                                    "image"};
  auto reader = root.FindMap("background", "the background");
  if (!reader) return;
  const std::size_t type = reader->Type(kTypes);
  if (!context_.ok()) return;
  Background& background = scene_.background;
  background.mark = reader->mark();
  if (type == 0) {
    background.kind = ConstantBackground{reader->Color("color", kNonNegative)};
  } else if (type == 1) {
    const Rgb bottom = reader->Color("bottom", kNonNegative);
    const Rgb top = reader->Color("top", kNonNegative);
    background.kind = GradientBackground{bottom, top};
  } else {
    background.kind = ImageBackground{File(*reader)};
  }
  reader->Finish();
}

void SceneReader::ReadSettings(MapReader& root) {
  constexpr int kMaxDepth = 64;
  auto reader = root.FindMap("settings", "the settings");
  if (!reader) return;
  Settings& settings = scene_.settings;
  settings.max_depth =
      reader->Integer("max_depth", 0, kMaxDepth, settings.max_depth);
  settings.ambient = reader->Color("ambient", kNonNegative, settings.ambient);
  settings.exposure = reader->Number("exposure", kStops, settings.exposure);
  reader->Finish();
}

}  // namespace rtb
