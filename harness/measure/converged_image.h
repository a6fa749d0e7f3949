/// @file
/// Our own converged image of a scene: what a reference is compared with, and
/// the reference where nobody else rendered one.
#pragma once

#include <filesystem>
#include <string>

#include "core/image/image.h"
#include "harness/prepared_scene.h"

namespace rtb {

/// Rays per pixel of a converged image.
inline constexpr int kSelfReferenceSpp = 64;
/// The same by the path integrator, whose rays are noisier.
inline constexpr int kSelfReferencePathSpp = 256;

/// Rays per pixel that an integrator's converged image takes.
int ConvergedSpp(const std::string& integrator);

/// The scene at `time` by the integrator, backend and threads of `scene`, in
/// the scene's own depth and with no seed: the picture that is to be
/// approached does not change with the other options of a run. Linear, not
/// exposed.
/// @param cache where the image is kept as an EXR whose name hashes all that
///   it depends on; empty: nowhere. The pixels are the same either way.
/// @return the renderer's errors, and those of writing to the cache.
Result<Image> ConvergedImage(const PreparedScene& scene, double time,
                             PixelSize size,
                             const std::filesystem::path& cache);

}  // namespace rtb
