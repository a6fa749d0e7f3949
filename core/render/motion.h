/// @file
/// Exact motion: where what each pixel shows was at another time. The flow:
/// Scene -> Moment at two times -> TraceMotion -> PixelMotion for each pixel.
#pragma once

#include <memory>
#include <vector>

#include "core/accel/embree_accel.h"
#include "core/base/result.h"
#include "core/render/camera_rays.h"
#include "core/scene/flat_scene.h"

namespace rtb {

/// A scene at one time, ready to be looked at: what eye rays meet, without
/// materials. Immutable once made.
class Moment {
 public:
  /// @param scene must outlive the moment.
  /// @param aspect width / height of the pictures.
  /// @param threads at most this many build it; 0 = all cores.
  /// @return the errors of Flatten, and of memory that does not suffice.
  static Result<std::unique_ptr<const Moment>> Make(const Scene& scene,
                                                    double time, double aspect,
                                                    int threads = 0);

  const CameraRays& camera() const { return camera_; }
  /// The primitives' objects, in an order that does not depend on the time.
  const std::vector<FlatObject>& objects() const { return flat_.objects; }
  /// What a ray meets first.
  Hit Closest(const Ray& ray) const { return accel_->Closest(ray); }
  /// Where that is; the hit is not kNothing.
  SurfacePoint Surface(const Ray& ray, const Hit& hit) const;

 private:
  Moment() = default;

  CameraRays camera_;
  FlatScene flat_;
  Geometry geometry_;
  std::unique_ptr<EmbreeAccel> accel_;
};

/// Whether a point can be seen on an earlier picture.
enum class Sight {
  kVisible,
  kHidden,   ///< Behind something else.
  kOutside,  ///< Beyond the picture's borders, or behind the camera.
};

/// What became of the point that a pixel's center shows.
struct PixelMotion {
  /// The same point of the same object then, in the world. Of the background,
  /// infinitely far away, the unit direction.
  V3d point{0};
  /// Where it was on the picture, in pixels from the top left corner; pixel
  /// centers are at halves. Meaningful unless kOutside.
  V2d place{0};
  Sight sight = Sight::kOutside;
};

/// Follows the first surface that each pixel's center shows, by the movement of
/// its object and of the camera, to another time. Reflections and shadows are
/// not followed: they move otherwise than the surface that shows them.
/// @param now,before moments of one scene and aspect.
/// @return width x height motions, row by row.
std::vector<PixelMotion> TraceMotion(const Moment& now, const Moment& before,
                                     int width, int height, int threads = 0);

}  // namespace rtb
