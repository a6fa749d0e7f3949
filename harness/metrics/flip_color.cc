#include "harness/metrics/flip_color.h"

#include <cmath>

#include "core/color/cielab.h"

namespace rtb {
namespace {

// The paper's names of its constants.
constexpr double kExponent = 0.7;    // q_c
constexpr double kKnee = 0.4;        // p_c, a share of the largest error
constexpr double kKneeError = 0.95;  // p_t

}  // namespace

V3d LinearToYcxcz(const V3d& linear) {
  const V3d xyz = LinearToXyz(linear);
  const double x = xyz.x / kWhiteX;
  const double y = xyz.y / kWhiteY;
  const double z = xyz.z / kWhiteZ;
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

V3d YcxczToLinear(const V3d& ycxcz) {
  const double y = (ycxcz.x + 16) / 116;
  const double x = y + ycxcz.y / 500;
  const double z = y - ycxcz.z / 200;
  return XyzToLinear({x * kWhiteX, y * kWhiteY, z * kWhiteZ});
}

V3d HuntLab(const V3d& linear) {
  const V3d lab = LinearToLab(linear);
  return {lab.x, 0.01 * lab.x * lab.y, 0.01 * lab.x * lab.z};
}

double HyAb(const V3d& a, const V3d& b) {
  const V3d d = a - b;
  return std::abs(d.x) + std::sqrt(d.y * d.y + d.z * d.z);
}

FlipErrorRange::FlipErrorRange()
    : max_(std::pow(HyAb(HuntLab({0, 1, 0}), HuntLab({0, 0, 1})), kExponent)) {}

double FlipErrorRange::operator()(double distance) const {
  const double error = std::pow(distance, kExponent);
  const double knee = kKnee * max_;
  if (error < knee) return error * kKneeError / knee;
  return kKneeError + (error - knee) / (max_ - knee) * (1 - kKneeError);
}

}  // namespace rtb
