/// @file
/// From an open image file to an Image.
#pragma once

#include <OpenImageIO/imageio.h>

#include <string>

#include "core/base/result.h"
#include "core/image/channels.h"
#include "core/image/image.h"

namespace rtb {

/// Reads the first image of a file as it is stored (no orientation), linear
/// and over black. An EXR's data window is placed on its display window.
/// @param name what Errors call the file.
Result<Image> ReadRaster(OIIO::ImageInput& input, const std::string& name,
                         Codes codes);

}  // namespace rtb
