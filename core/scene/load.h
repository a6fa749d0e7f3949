/// @file
/// Reads a scene file (YAML, or JSON as its subset) into a Scene.
#pragma once

#include <filesystem>
#include <string>

#include "core/base/result.h"
#include "core/scene/scene.h"

namespace rtb {

/// Loads and validates a scene file and the meshes that it names (paths are
/// relative to the scene file). Every key of the format is parsed; whether
/// this build can render what the scene asks for is a separate question: see
/// CheckRenderable.
/// @return the Scene, or an Error whose place is `file:line:column`.
Result<Scene> LoadScene(const std::filesystem::path& file);

/// The same from text; `file` names it in errors and anchors relative paths.
Result<Scene> ParseScene(const std::string& text,
                         const std::filesystem::path& file);

/// Success when every feature that the scene uses is rendered by this build;
/// else an Error that names the first key that is not rendered yet.
Status CheckRenderable(const Scene& scene);

}  // namespace rtb
