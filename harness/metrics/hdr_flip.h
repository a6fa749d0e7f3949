/// @file
/// HDR-FLIP: the error of linear renders over all exposures that show
/// something. Andersson, Nilsson, Shirley and Akenine-Moeller, "Visualizing
/// Errors in Rendered High Dynamic Range Images", Eurographics 2021 (short
/// papers).
#pragma once

#include "core/base/result.h"
#include "core/image/image.h"
#include "harness/metrics/channel_plane.h"
#include "harness/metrics/flip_map.h"

namespace rtb {

/// The exposures at which two images are compared, in stops.
struct ExposureRange {
  double start = 0;
  double stop = 0;
  int count = 2;  ///< Evenly spaced, both ends included.

  double At(int i) const { return start + (stop - start) * i / (count - 1); }
};

/// The ACES tone curve at x >= 0: Narkowicz, "ACES Filmic Tone Mapping Curve",
/// 2016, without that fit's pre-exposure of 0.6, as HDR-FLIP takes it.
double AcesTone(double x);

/// Section 3 of the paper: from the exposure at which the reference's largest
/// luminance is toned to 0.85 to that at which its median is.
/// @param reference linear, of at least one pixel.
/// @return kBadInput for a reference whose median luminance is 0 (more than
///   half of it is black), and for one that is not finite.
Result<ExposureRange> FlipExposures(const Image& reference);

/// Mean over pixels of the largest LDR-FLIP at any of the exposures, each tone
/// mapped by ACES and clipped to [0, 1].
/// @param reference,test linear, not exposed; negative values count as 0.
/// @param ppd pixels per degree.
/// @return kBadInput for different sizes, and the errors of FlipExposures.
Result<double> HdrFlip(const Image& reference, const Image& test,
                       int threads = 0, double ppd = kFlipPpd);

}  // namespace rtb
