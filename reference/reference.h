/// @file
/// References: images of a scene by another renderer, with their provenance.
/// What the renderers share; each has a header of its own.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "core/scene/scene.h"

namespace rtb {

/// Version of the provenance's form.
inline constexpr int kProvenanceSchema = 1;

/// What to render.
struct ReferenceRequest {
  int width = 960;
  int height = 640;
  int spp = 64;  ///< POV-Ray: a square number, an n x n grid of centers.
  double time = 0;
  std::filesystem::path output;  ///< The EXR; provenance goes beside it.
  /// POV-Ray only: points of an area light that each ray is lit by (twice as
  /// many of a sphere). Every ray of a pixel has others.
  int emitters = 34;
  int seed = 0;  ///< Cycles only: another one, other noise.
  /// Cycles only: `path`, the full light transport, or `whitted`.
  std::string integrator = "path";
  /// Cycles only: every ray goes through its pixel's center, as ours do at
  /// one ray per pixel, instead of anywhere in the pixel.
  bool pixel_centers = false;
  bool nice = false;  ///< Cycles only: lets other programs go first.
};

/// Called now and then with the finished share, 0..1.
using Progress = std::function<void(double share, const std::string& what)>;

/// Where the reference of a scene lives: `FOLDER/NAME.RENDERER.exr`, at any
/// time but 0 `FOLDER/NAME.tTIME.RENDERER.exr` with the shortest digits that
/// read back the same, as `cornell.t2.5.povray.exr`; with a seed other than 0
/// `FOLDER/NAME.RENDERER.seedN.exr`.
std::filesystem::path ReferencePath(const std::filesystem::path& folder,
                                    const std::string& scene_name,
                                    const std::string& renderer,
                                    double time = 0, int seed = 0);

}  // namespace rtb
