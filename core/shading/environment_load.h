/// @file
/// Environment: the host's side of EnvironmentData.
#pragma once

#include <filesystem>
#include <vector>

#include "core/base/result.h"
#include "core/image/image.h"
#include "core/shading/environment.h"

namespace rtb {

/// A latitude-longitude image of scene-linear radiance with the tables for
/// sampling it.
struct Environment {
  Image image;
  std::vector<float> row_cdf;
  std::vector<float> column_cdfs;
  double mean_luminance = 0;  ///< Over all directions.
};

/// Builds the tables. The image is not empty, its values are finite and not
/// negative.
Environment MakeEnvironment(Image image);

/// Reads an image (integer codes are sRGB-encoded, floats linear). An Error
/// names the file, and the pixel where a value is no radiance.
Result<Environment> LoadEnvironment(const std::filesystem::path& file);

/// Bare pointers into an Environment, which must outlive them.
EnvironmentData ViewOf(const Environment& environment);

}  // namespace rtb
