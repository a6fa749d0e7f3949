/// @file
/// The color spaces and the color difference of FLIP: the color pipeline of
/// Andersson et al., "FLIP: A Difference Evaluator for Alternating Images",
/// Proc. ACM Comput. Graph. Interact. Tech. 3(2) (HPG 2020), section 4.1.
#pragma once

#include "core/math/vec.h"

namespace rtb {

/// Linear BT.709 to YCxCz, a linearized CIELAB in which filtering is right: Y
/// in [-16, 100], Cx red-green, Cz blue-yellow.
V3d LinearToYcxcz(const V3d& linear);

/// The inverse.
V3d YcxczToLinear(const V3d& ycxcz);

/// Linear BT.709 to CIELAB with the Hunt effect: chroma fades with lightness.
V3d HuntLab(const V3d& linear);

/// The HyAB distance: city block in lightness, Euclidean in chroma.
double HyAb(const V3d& a, const V3d& b);

/// Maps HyAB distances to color errors in [0, 1]: an exponent, and a
/// compression that leaves most of the range to the smaller errors.
class FlipErrorRange {
 public:
  FlipErrorRange();
  double operator()(double distance) const;

 private:
  double max_;  ///< Of green against blue, the largest that can be displayed.
};

}  // namespace rtb
