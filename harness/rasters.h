/// @file
/// Rasters that metrics may compare: a reference and a test brought to one
/// size and to display encoding, by the grid rule.
#pragma once

#include <filesystem>
#include <string>

#include "core/base/result.h"
#include "core/image/image.h"
#include "harness/arguments.h"

namespace rtb {

/// Whether files of that name hold linear light: .exr, .hdr, .pfm.
bool HoldsLinearLight(const std::filesystem::path& file);

/// The linear values of sRGB-encoded ones in [0, 1].
Image LinearOf(const Image& encoded);

/// A picture as a display shows it: clipped, sRGB-encoded, rounded to 8 bits.
/// Files of linear light (.exr, .hdr, .pfm) are exposed first.
/// @param exposure in stops.
Result<Image> ReadDisplayed(const std::filesystem::path& file, double exposure);

/// Success when two sizes show the same picture: aspects within 0.1 %.
/// @param place names the reference in errors.
Status CheckAspects(PixelSize reference, PixelSize test,
                    const std::string& place);

/// Two rasters of one size, sRGB-encoded values in [0, 1].
struct RasterPair {
  Image reference;
  Image test;
  PixelSize reference_size;  ///< Before it was reduced.
  PixelSize test_size;       ///< Before it was reduced.
};

/// Brings both to the smaller width and the smaller height, so that neither is
/// enlarged, by exact area averaging in linear light. Equal sizes stay as they
/// are.
/// @param place names the reference in errors.
/// @return kBadInput when the aspects differ by more than 0.1 %.
Result<RasterPair> MatchRasters(const Image& reference, const Image& test,
                                const std::string& place);

}  // namespace rtb
