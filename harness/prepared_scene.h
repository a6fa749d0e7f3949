/// @file
/// PreparedScene: a scene looked up, loaded and made ready to render, with
/// what the command line overrides.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "core/image/image.h"
#include "core/render/backend.h"
#include "core/scene/scene.h"
#include "harness/arguments.h"
#include "harness/scene_source.h"

namespace rtb {

/// What a user asks for.
struct SceneRequest {
  std::string scene;  ///< Name or file.
  std::string backend = "embree";
  std::optional<double> exposure;  ///< Stops; none = the scene's.
  RenderOptions options;
};

/// A scene ready to render.
struct PreparedScene {
  std::filesystem::path file;
  std::unique_ptr<Scene> scene;
  std::unique_ptr<Backend> backend;
  RenderOptions options;
  double exposure = 0;

  /// A source that renders it, exposure applied.
  SceneSource Source() const { return {*backend, options, exposure}; }
};

/// Looks a scene up, loads it and makes the backend.
Result<PreparedScene> PrepareScene(const SceneRequest& request);

/// Loads a scene without making it ready to render.
Result<PreparedScene> LoadNamedScene(const std::string& name_or_file);

/// Renders one sample per pixel: linear, not exposed. Many rays are traced in
/// bands of rows, which changes nothing in the image.
/// @param progress called with the share of the image that is there.
Result<Image> RenderImage(
    Backend& backend, PixelSize size, const RenderOptions& options,
    const std::function<void(double share)>& progress = [](double) {});

}  // namespace rtb
