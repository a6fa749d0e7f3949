/// @file
/// Whether a reference image shows what its name says: the provenance beside
/// it against the scene, the time and the image's own bytes.
#pragma once

#include <filesystem>
#include <string>

#include "core/base/result.h"
#include "core/scene/scene.h"

namespace rtb {

/// Checks the provenance `<image>.json` of a reference: its schema, who
/// rendered it, at which time, of which scene, and that the image's SHA-256 is
/// the one it states. A scene is known by the hash of its file; a scene with
/// meshes or images, or a file that was changed, by the hash of its translation
/// for the renderer, which holds the composed geometry.
/// @return kBadInput, at the image, that says what does not fit.
Status CheckProvenance(const std::filesystem::path& image,
                       const std::string& renderer, const Scene& scene,
                       double time);

}  // namespace rtb
