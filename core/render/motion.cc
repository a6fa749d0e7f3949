#include "core/render/motion.h"

#include <cmath>

#include "core/accel/surface.h"
#include "core/base/check.h"
#include "core/base/parallel.h"
#include "core/scene/animation.h"

namespace rtb {
namespace {

/// Relative difference of distances up to which a ray meets the point that it
/// was sent to: above the rounding of single precision even at grazing angles.
constexpr double kSameDistance = 1e-3;

/// A place on the picture plane, x to the right and y down, in [0, 1] inside.
struct PicturePlace {
  V2d xy{0};
  bool inside = false;
};

/// Where a camera sees what lies in a direction from it: EyeRay's inverse.
PicturePlace Project(const CameraRays& camera, const V3d& direction) {
  const double depth = direction.dot(camera.forward);
  if (!(depth > 0)) return {};
  const double right =
      direction.dot(camera.right) / (camera.right.length2() * depth);
  const double up = direction.dot(camera.up) / (camera.up.length2() * depth);
  const V2d xy((1 + right) / 2, (1 - up) / 2);
  const bool inside = xy.x >= 0 && xy.x <= 1 && xy.y >= 0 && xy.y <= 1;
  return {xy, inside};
}

/// Follows points from one moment to another.
class Follower {
 public:
  Follower(const Moment& now, const Moment& before)
      : now_(now), before_(before) {
    RTB_CHECK_EQ(now.objects().size(), before.objects().size());
    for (std::size_t i = 0; i < now.objects().size(); ++i) {
      moves_.push_back(before.objects()[i].object_to_world *
                       now.objects()[i].object_to_world.Inverse());
    }
  }

  /// What is seen at (x, y) of the picture, in [0, 1].
  PixelMotion Follow(double x, double y) const {
    const Ray ray = EyeRay(now_.camera(), x, y);
    const Hit hit = now_.Closest(ray);
    if (hit.kind == PrimitiveKind::kNothing) return FollowBackground(ray);
    const SurfacePoint surface = now_.Surface(ray, hit);
    const auto object = static_cast<std::size_t>(surface.object);
    PixelMotion motion;
    motion.point = Moved(object, V3d(surface.position));
    const V3d way = motion.point - before_.camera().position;
    const PicturePlace place = Project(before_.camera(), way);
    if (!place.inside) return motion;
    motion.place = place.xy;
    motion.sight = Sees(place, surface.object, way.length()) ? Sight::kVisible
                                                             : Sight::kHidden;
    return motion;
  }

 private:
  /// A point that stands still stays as it is, bit for bit.
  V3d Moved(std::size_t object, const V3d& point) const {
    const Affined& then = before_.objects()[object].object_to_world;
    const Affined& now = now_.objects()[object].object_to_world;
    const bool still = then.x == now.x && then.y == now.y && then.z == now.z &&
                       then.origin == now.origin;
    return still ? point : moves_[object].Point(point);
  }

  PixelMotion FollowBackground(const Ray& ray) const {
    PixelMotion motion;
    motion.point = V3d(ray.direction);
    const PicturePlace place = Project(before_.camera(), motion.point);
    if (!place.inside) return motion;
    motion.place = place.xy;
    const Ray back = EyeRay(before_.camera(), place.xy.x, place.xy.y);
    const Hit hit = before_.Closest(back);
    motion.sight =
        hit.kind == PrimitiveKind::kNothing ? Sight::kVisible : Sight::kHidden;
    return motion;
  }

  /// Whether the first thing there was the object at that distance.
  bool Sees(const PicturePlace& place, int object, double distance) const {
    const Ray ray = EyeRay(before_.camera(), place.xy.x, place.xy.y);
    const Hit hit = before_.Closest(ray);
    if (hit.kind == PrimitiveKind::kNothing) return false;
    return before_.Surface(ray, hit).object == object &&
           std::abs(double{hit.t} - distance) <= kSameDistance * distance;
  }

  const Moment& now_;
  const Moment& before_;
  std::vector<Affined> moves_;  ///< Of each object, in the world.
};

}  // namespace

Result<std::unique_ptr<const Moment>> Moment::Make(const Scene& scene,
                                                   double time, double aspect,
                                                   int threads) {
  std::unique_ptr<Moment> moment(new Moment);
  moment->camera_ = MakeCameraRays(CameraAt(scene, time), aspect);
  RTB_ASSIGN_OR_RETURN(moment->flat_, Flatten(scene, time));
  RTB_RETURN_IF_ERROR(
      AddLightShapes(scene, time, FlatPart::kAll, &moment->flat_));
  moment->geometry_ = MakeGeometry(moment->flat_, scene.meshes);
  const std::vector<Rgb> opaque(moment->geometry_.objects.size(), Rgb(0));
  RTB_ASSIGN_OR_RETURN(EmbreeAccel accel,
                       EmbreeAccel::Build(moment->geometry_, opaque, threads));
  moment->accel_ = std::make_unique<EmbreeAccel>(std::move(accel));
  return std::unique_ptr<const Moment>(std::move(moment));
}

SurfacePoint Moment::Surface(const Ray& ray, const Hit& hit) const {
  return SurfaceAt(accel_->geometry(), ray, hit);
}

std::vector<PixelMotion> TraceMotion(const Moment& now, const Moment& before,
                                     int width, int height, int threads) {
  const Follower follower(now, before);
  std::vector<PixelMotion> motions(static_cast<std::size_t>(width) *
                                   static_cast<std::size_t>(height));
  ParallelFor(height, 8, threads, [&](int begin, int end) {
    auto motion = motions.begin() + static_cast<std::ptrdiff_t>(begin) * width;
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < width; ++x, ++motion) {
        *motion = follower.Follow((x + 0.5) / width, (y + 0.5) / height);
        motion->place *= V2d(width, height);
      }
    }
  });
  return motions;
}

}  // namespace rtb
