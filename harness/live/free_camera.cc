#include "harness/live/free_camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/math/frame.h"

namespace rtb {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kSettle = 0.08;    // Seconds to reach 63 % of a speed.
constexpr double kTurnSpeed = 1.2;  // Radians per second.
constexpr double kHurry = 4;        // How much faster shift goes.
constexpr double kSteepest = kPi / 2 - 0.01;
constexpr double kFarthest = 1e7;    // Of each coordinate.
constexpr double kNarrowest = 0.01;  // Of tan_half_vfov: about 1 degree.
constexpr double kWidest = 4;        // About 150 degrees.

}  // namespace

double FreeCamera::Smoothed::Step(double target, double seconds) {
  // The solution of value' = (target - value) / kSettle, and its integral.
  const double decay = std::exp(-seconds / kSettle);
  const double lag = value - target;
  value = target + lag * decay;
  return target * seconds + lag * kSettle * (1 - decay);
}

FreeCamera::FreeCamera(const CameraFrame& frame, const V3d& up, double speed)
    : position_(frame.position),
      up_(up.normalized()),
      north_(frame.forward - up_ * frame.forward.dot(up_)),
      east_(0),
      pitch_(std::asin(std::clamp(frame.forward.dot(up_), -1.0, 1.0))),
      tan_half_vfov_(frame.tan_half_vfov),
      speed_(speed) {
  // Looking straight up or down, the picture's other axis shows the way.
  if (north_.length() < 1e-6) north_ = up_.cross(frame.right);
  if (north_.length() < 1e-6) north_ = TangentsOf(up_).s;
  north_.normalize();
  east_ = north_.cross(up_);
  pitch_ = std::clamp(pitch_, -kSteepest, kSteepest);
}

V3d FreeCamera::Forward() const {
  const V3d level = north_ * std::cos(yaw_) + east_ * std::sin(yaw_);
  return level * std::cos(pitch_) + up_ * std::sin(pitch_);
}

V3d FreeCamera::Right() const {
  return east_ * std::cos(yaw_) - north_ * std::sin(yaw_);
}

void FreeCamera::Step(const MotionInput& input, double seconds) {
  const double hurry = input.hurry ? kHurry : 1;
  // Half of the turn before and half after the way: the order does not show.
  const double turn_right = turn_right_.Step(input.turn_right, seconds);
  const double turn_up = turn_up_.Step(input.turn_up, seconds);
  Look(turn_right * kTurnSpeed / 2, turn_up * kTurnSpeed / 2);
  const double forward = forward_.Step(input.forward * hurry, seconds);
  const double right = right_.Step(input.right * hurry, seconds);
  const double rise = rise_.Step(input.up * hurry, seconds);
  MoveTo(position_ +
         (Forward() * forward + Right() * right + up_ * rise) * speed_);
  Look(turn_right * kTurnSpeed / 2, turn_up * kTurnSpeed / 2);
}

void FreeCamera::MoveTo(const V3d& position) {
  for (int axis = 0; axis < 3; ++axis) {
    if (!std::isfinite(position[axis])) return;
    position_[axis] = std::clamp(position[axis], -kFarthest, kFarthest);
  }
}

void FreeCamera::Look(double right, double up) {
  // Narrow views turn more slowly.
  const double scale = std::min(1.0, tan_half_vfov_ * 2.5);
  yaw_ = std::remainder(yaw_ + right * scale, 2 * kPi);
  pitch_ = std::clamp(pitch_ + up * scale, -kSteepest, kSteepest);
}

void FreeCamera::Zoom(double steps) {
  tan_half_vfov_ =
      std::clamp(tan_half_vfov_ * std::pow(1.1, steps), kNarrowest, kWidest);
}

void FreeCamera::Orbit(double angle, double distance) {
  const V3d center = position_ + Forward() * distance;
  yaw_ = std::remainder(yaw_ + angle, 2 * kPi);
  MoveTo(center - Forward() * distance);
}

bool FreeCamera::moving() const {
  constexpr double kStill = 1e-3;
  return std::max({std::abs(forward_.value), std::abs(right_.value),
                   std::abs(rise_.value), std::abs(turn_right_.value),
                   std::abs(turn_up_.value)}) > kStill;
}

CameraFrame FreeCamera::frame() const {
  CameraFrame frame{.position = position_,
                    .right = Right(),
                    .up = V3d(0),
                    .forward = Forward(),
                    .tan_half_vfov = tan_half_vfov_};
  frame.up = frame.right.cross(frame.forward);
  return frame;
}

}  // namespace rtb
