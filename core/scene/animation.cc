#include "core/scene/animation.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/math/frame.h"

namespace rtb {
namespace {

/// A place on a path: the segment that starts at point `first`, and the share
/// of it that has been travelled.
struct Place {
  int first;
  double share;
};

int Count(const Path& path) { return static_cast<int>(path.points.size()); }

Place Locate(const Path& path, double time) {
  double t = std::max(time, 0.0);
  if (path.loop && path.duration > 0) {
    t = std::fmod(time, path.duration);
    if (t < 0) t += path.duration;
  }
  const auto next = std::upper_bound(path.times.begin(), path.times.end(), t);
  const int first =
      std::max(0, static_cast<int>(next - path.times.begin()) - 1);
  const bool last = first + 1 == Count(path);
  if (last && !path.loop) return {first, 0};
  const double start = path.times[static_cast<std::size_t>(first)];
  const double end = last ? path.duration : *next;
  return {first, end > start ? (t - start) / (end - start) : 0};
}

/// The point of that number, wrapped on a loop, doubled at an open end.
const V3d& PointAt(const Path& path, int index) {
  const int count = Count(path);
  const int inside = path.loop ? ((index % count) + count) % count
                               : std::clamp(index, 0, count - 1);
  return path.points[static_cast<std::size_t>(inside)];
}

/// Uniform Catmull-Rom spline: Catmull and Rom, "A Class of Local
/// Interpolating Splines", 1974, with tangents (p[i+1] - p[i-1]) / 2.
V3d CatmullRom(const V3d& p0, const V3d& p1, const V3d& p2, const V3d& p3,
               double u) {
  const V3d a = (p1 * 3.0 - p0 - p2 * 3.0 + p3) * 0.5;
  const V3d b = (p0 * 2.0 - p1 * 5.0 + p2 * 4.0 - p3) * 0.5;
  const V3d c = (p2 - p0) * 0.5;
  return ((a * u + b) * u + c) * u + p1;
}

V3d OffsetOf(const Scene& scene, Index path, double time) {
  if (path == kNone) return V3d(0);
  return PathOffset(scene.paths[static_cast<std::size_t>(path)], time);
}

}  // namespace

V3d PathOffset(const Path& path, double time) {
  const Place place = Locate(path, time);
  const V3d& p1 = PointAt(path, place.first);
  if (place.share == 0) return p1;
  const V3d& p2 = PointAt(path, place.first + 1);
  if (path.interpolation == Path::Interpolation::kLinear) {
    return p1 + (p2 - p1) * place.share;
  }
  return CatmullRom(PointAt(path, place.first - 1), p1, p2,
                    PointAt(path, place.first + 2), place.share);
}

V3d LightOffset(const Scene& scene, const Light& light, double time) {
  return OffsetOf(scene, light.path, time);
}

CameraFrame CameraAt(const Scene& scene, double time) {
  const Camera& camera = scene.camera;
  CameraFrame frame;
  frame.position = camera.position + OffsetOf(scene, camera.path, time);
  frame.forward = camera.direction;
  if (camera.has_look_at) {
    frame.forward = camera.look_at + OffsetOf(scene, camera.look_path, time) -
                    frame.position;
  }
  if (frame.forward.length() == 0) frame.forward = V3d(0, 0, -1);
  frame.forward.normalize();
  frame.right = frame.forward.cross(camera.up);
  if (frame.right.length() == 0) frame.right = TangentsOf(frame.forward).s;
  frame.right.normalize();
  frame.up = frame.right.cross(frame.forward);
  frame.tan_half_vfov = std::tan(camera.vfov * std::numbers::pi / 360);
  return frame;
}

}  // namespace rtb
