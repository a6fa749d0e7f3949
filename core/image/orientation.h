/// @file
/// Turning an image the way its EXIF orientation asks for.
#pragma once

#include "core/image/image.h"

namespace rtb {

/// The image as it is meant to be seen.
/// @param orientation EXIF 2.32, tag 0x0112: 1 to 8; anything else is 1.
Image Upright(Image image, int orientation);

}  // namespace rtb
