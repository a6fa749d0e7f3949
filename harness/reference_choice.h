/// @file
/// The picture that a benchmark compares with.
#pragma once

#include <optional>
#include <string>

#include "harness/prepared_scene.h"

namespace rtb {

/// Rays per pixel of our own converged image.
inline constexpr int kSelfReferenceSpp = 64;

/// A reference as a display shows it.
struct ReferencePicture {
  Image display;     ///< sRGB-encoded, rounded to 8 bits.
  std::string name;  ///< `povray`, `cycles`, `self`, or a file's name.
  std::filesystem::path file;  ///< Empty for `self`.
};

/// The reference of a scene for a raster of the given size.
/// @param choice `povray`, `cycles`, `self`, a file, or empty: the first of
///   the three that there is. Committed references show time 0; at another
///   time the default is `self`.
/// @return kBadInput when there is no such reference or its aspect is not the
/// raster's.
Result<ReferencePicture> ChooseReference(const std::string& choice,
                                         const PreparedScene& scene,
                                         PixelSize raster);

}  // namespace rtb
