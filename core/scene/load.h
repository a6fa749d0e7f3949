/// @file
/// Reads a scene file (YAML, or JSON as its subset) into a Scene.
#pragma once

#include <filesystem>
#include <string>

#include "core/base/result.h"
#include "core/scene/scene.h"

namespace rtb {

/// Loads and validates a scene file and the meshes that it names (paths are
/// relative to the scene file).
/// @return the Scene, or an Error whose place is `file:line:column`.
Result<Scene> LoadScene(const std::filesystem::path& file);

/// The same from text; `file` names it in errors and anchors relative paths.
Result<Scene> ParseScene(const std::string& text,
                         const std::filesystem::path& file);

}  // namespace rtb
