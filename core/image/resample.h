/// @file
/// Area averaging: the one resampling of the program.
#pragma once

#include "core/image/image.h"

namespace rtb {

/// Mean of the image over the box [x0, x1) x [y0, y1), in pixels, weighted by
/// the exact area covered of each pixel. The part of the box outside the
/// image counts as black. Pixels that the box covers exactly come out exactly:
/// a side within 1e-5 pixels of a pixel's border counts as on it.
/// Needs x0 < x1 and y0 < y1.
Rgb BoxMean(const Image& image, double x0, double y0, double x1, double y1);

/// The image at another size, each pixel the exact area average of its
/// footprint in the source. Averages the values as they are: pass linear ones.
/// Needs a source of at least one pixel, and a size of at least 1x1.
Image ResizeArea(const Image& image, int width, int height);

}  // namespace rtb
