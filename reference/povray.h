/// @file
/// References: images of a scene by another renderer, with their provenance.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "core/base/result.h"
#include "core/scene/scene.h"

namespace rtb {

/// Version of the provenance's form.
inline constexpr int kProvenanceSchema = 1;

/// What to render.
struct ReferenceRequest {
  int width = 960;
  int height = 640;
  int spp = 64;  ///< A square number: an n x n grid of centers per pixel.
  double time = 0;
  std::filesystem::path output;  ///< The EXR; provenance goes beside it.
};

/// Called now and then with the finished share, 0..1.
using Progress = std::function<void(double share, const std::string& what)>;

/// Renders a reference with POV-Ray in row bands that survive an interruption
/// (a second call with the same request continues), averages the samples of
/// each pixel in linear light, and writes a half-float EXR and a provenance
/// JSON, both atomically.
/// @return kMissing (with how to get it) when povray is not installed.
Status RenderPovReference(const Scene& scene, const ReferenceRequest& request,
                          const Progress& progress);

/// Where the reference of a scene lives: `FOLDER/NAME.RENDERER.exr`, at any
/// time but 0 `FOLDER/NAME.tTIME.RENDERER.exr` with the shortest digits that
/// read back the same, as `cornell.t2.5.povray.exr`.
std::filesystem::path ReferencePath(const std::filesystem::path& folder,
                                    const std::string& scene_name,
                                    const std::string& renderer,
                                    double time = 0);

}  // namespace rtb
