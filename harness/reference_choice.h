/// @file
/// The picture that a benchmark compares with.
#pragma once

#include <string>
#include <vector>

#include "harness/prepared_scene.h"

namespace rtb {

/// A reference as a display shows it.
struct ReferencePicture {
  Image display;     ///< sRGB-encoded, rounded to 8 bits.
  std::string name;  ///< `povray`, `cycles`, `self`, or a file's name.
  std::filesystem::path file;  ///< Empty for `self`.
  /// What a user should know of a default choice, one sentence each.
  std::vector<std::string> notes = {};
};

/// Where a reference comes from.
struct ReferenceSource {
  std::string name;  ///< `povray`, `cycles`, `self`, or a file's name.
  std::filesystem::path file = {};      ///< Empty for `self`.
  std::vector<std::string> notes = {};  ///< As ReferencePicture has them.
};

/// Which reference a choice means for a scene, without reading or rendering
/// it; the errors are ChooseReference's.
Result<ReferenceSource> FindReferenceSource(const std::string& choice,
                                            const PreparedScene& scene);

/// The reference of a scene for a raster of the given size.
/// @param choice `povray`, `cycles`, `self`, a file, or empty: the first of
///   the three that there is. References by name are looked up for the scene's
///   time; one that CheckProvenance refuses is not used by default, which the
///   notes say.
/// @param cache ConvergedImage's, for `self`; empty: none.
/// @return kBadInput when there is no such reference, CheckProvenance refuses
/// it, or its aspect is not the raster's.
Result<ReferencePicture> ChooseReference(
    const std::string& choice, const PreparedScene& scene, PixelSize raster,
    const std::filesystem::path& cache = {});

}  // namespace rtb
