#include "core/color/oklab.h"

#include <cmath>

namespace rtb {
namespace {

/// Three rows of a matrix, each dotted with a color.
struct Rows {
  V3d x, y, z;
  V3d operator*(const V3d& v) const { return {x.dot(v), y.dot(v), z.dot(v)}; }
};

// Ottosson 2020, "Converting from linear sRGB to Oklab".
const Rows kLinearToLms = {{0.4122214708, 0.5363325363, 0.0514459929},
                           {0.2119034982, 0.6806995451, 0.1073969566},
                           {0.0883024619, 0.2817188376, 0.6299787005}};
const Rows kRootToLab = {{0.2104542553, 0.7936177850, -0.0040720468},
                         {1.9779984951, -2.4285922050, 0.4505937099},
                         {0.0259040371, 0.7827717662, -0.8086757660}};
const Rows kLabToRoot = {{1, 0.3963377774, 0.2158037573},
                         {1, -0.1055613458, -0.0638541728},
                         {1, -0.0894841775, -1.2914855480}};
const Rows kLmsToLinear = {{4.0767416621, -3.3077115913, 0.2309699292},
                           {-1.2684380046, 2.6097574011, -0.3413193965},
                           {-0.0041960863, -0.7034186147, 1.7076147010}};

}  // namespace

V3d LinearToOklab(const V3d& linear) {
  const V3d lms = kLinearToLms * linear;
  return kRootToLab * V3d(std::cbrt(lms.x), std::cbrt(lms.y), std::cbrt(lms.z));
}

V3d OklabToLinear(const V3d& lab) {
  const V3d root = kLabToRoot * lab;
  return kLmsToLinear * (root * root * root);
}

}  // namespace rtb
