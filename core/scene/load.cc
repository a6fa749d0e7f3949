#include "core/scene/load.h"

#include <utility>

#include "core/base/file.h"
#include "core/scene/scene_reader.h"

namespace rtb {
namespace {

/// Reports an error about the file itself as bad input.
Error AboutFile(const std::filesystem::path& file, const std::string& what,
                const std::string& hint = "") {
  return BadInput(file.string(), what, hint);
}

}  // namespace

Result<Scene> ParseScene(const std::string& text,
                         const std::filesystem::path& file) {
  RTB_ASSIGN_OR_RETURN(const YamlTree tree, ParseYaml(text, file.string()));
  ReadContext context(file);
  SceneReader reader(file, context);
  reader.Read(YamlNode(tree, 0));
  if (!context.ok()) return Fail(context.error());
  IndexObjects(&reader.scene());
  RTB_RETURN_IF_ERROR(CheckComposition(reader.scene()));
  reader.scene().sha256 = Sha256(text);
  return std::move(reader.scene());
}

Result<Scene> LoadScene(const std::filesystem::path& file) {
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) {
    return Fail(AboutFile(file, "there is no such scene file"));
  }
  if (std::filesystem::is_directory(file, ignored)) {
    return Fail(AboutFile(file, "is a folder, expected a scene file"));
  }
  const Result<std::string> text = ReadFile(file, kMaxYamlBytes);
  if (!text) {
    return Fail(
        BadInput(text.error().place, text.error().what, text.error().hint));
  }
  return ParseScene(*text, file);
}

}  // namespace rtb
