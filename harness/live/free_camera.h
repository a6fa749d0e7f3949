/// @file
/// FreeCamera: a camera that a person moves.
#pragma once

#include "core/scene/animation.h"
#include "harness/live/held_keys.h"

namespace rtb {

/// Walks and looks around with smoothed speeds; world up stays up. Positions
/// stay finite. What Step does in one second does not depend on how many
/// steps it is cut into.
class FreeCamera {
 public:
  /// @param up the scene's; @param speed in units per second, > 0.
  FreeCamera(const CameraFrame& frame, const V3d& up, double speed);

  /// Moves on by `seconds` with these keys held all the while.
  void Step(const MotionInput& input, double seconds);

  /// Turns at once, in radians (the mouse).
  void Look(double right, double up);

  /// Widens (> 0) or narrows the field of view by steps of a tenth.
  void Zoom(double steps);

  /// Turns around the point `distance` ahead, in radians, looking at it.
  void Orbit(double angle, double distance);

  /// Whether it still moves without keys.
  bool moving() const;

  CameraFrame frame() const;

 private:
  /// A value that follows a target with a time constant.
  struct Smoothed {
    double value = 0;
    /// Goes on by `seconds` towards `target`. @return the integral of value.
    double Step(double target, double seconds);
  };

  V3d Forward() const;
  V3d Right() const;
  void MoveTo(const V3d& position);

  V3d position_;
  V3d up_;     ///< World's.
  V3d north_;  ///< Horizontal, where yaw is 0.
  V3d east_;   ///< Horizontal, where yaw is a right angle.
  double yaw_ = 0;
  double pitch_ = 0;
  double tan_half_vfov_;
  double speed_;
  Smoothed forward_, right_, rise_, turn_right_, turn_up_;
};

}  // namespace rtb
