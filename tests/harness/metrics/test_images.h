/// @file
/// Images for the tests of metrics.
#pragma once

#include <string>

#include "core/image/image.h"

namespace rtb {

/// tests/data/metrics/<name>.png as encoded values, multiples of 1/255.
Image MetricImage(const std::string& name);

/// 192 x 176 pixels of smooth color, edges and texture.
Image Pattern();

/// The mean of each 3 x 3 neighborhood, borders replicated, `times` times.
Image Blurred(Image image, int times);

/// Uniform noise in [-amplitude, amplitude] on each channel, clipped.
Image Noisy(const Image& image, float amplitude);

/// @name The image mirrored or turned.
/// @{
Image MirroredX(const Image& image);
Image MirroredY(const Image& image);
Image Transposed(const Image& image);
/// @}

}  // namespace rtb
