/// @file
/// The filter kernels of FLIP: Andersson, Nilsson, Akenine-Moeller, Oskarsson,
/// Astrom and Fairchild, "FLIP: A Difference Evaluator for Alternating
/// Images", Proc. ACM Comput. Graph. Interact. Tech. 3(2) (HPG 2020).
#pragma once

#include "harness/metrics/convolve.h"

namespace rtb {

/// The contrast sensitivity filters of section 4.1, sampled on the pixel
/// grid. A filter with two Gaussians is not separable, but each Gaussian is:
/// blue_yellow = share[0] G0 x G0 + share[1] G1 x G1, which sums to 1.
struct FlipSensitivity {
  Kernel achromatic;
  Kernel red_green;
  Kernel blue_yellow[2];
  double share[2];
};

/// @param ppd pixels per degree of visual angle.
FlipSensitivity MakeFlipSensitivity(double ppd);

/// The feature detectors of section 4.2: a filter across the feature is a
/// derivative, along it the Gaussian. Positive and negative weights of a
/// derivative add up to 1 and -1.
struct FlipFeatures {
  Kernel gaussian;
  Kernel edge;   ///< First derivative.
  Kernel point;  ///< Second derivative.
};

/// @param ppd pixels per degree of visual angle.
FlipFeatures MakeFlipFeatures(double ppd);

}  // namespace rtb
