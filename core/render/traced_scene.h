/// @file
/// TracedScene: a Scene at one time with an accelerator over it, for every
/// backend. The flow: Scene -> TracedScene::GoTo(time) -> RenderPlan.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "core/accel/geometry.h"
#include "core/base/result.h"
#include "core/scene/scene.h"
#include "core/shading/shading_scene.h"

namespace rtb {

/// The parts that every accelerator is built from.
struct SceneParts {
  Geometry geometry;
  ShadingScene shading;
};

/// Composes a scene at a time.
/// @return the errors of Flatten and MakeShadingScene.
Result<SceneParts> PrepareParts(const Scene& scene, double time);

/// Takes the parts to another time; only what moves is touched.
Status MoveParts(const Scene& scene, double time, SceneParts* parts);

/// What shadow rays lose at each object's surface; lights are opaque.
std::vector<Rgb> Transmittances(const SceneParts& parts);

/// A scene that follows the time.
/// @tparam Accel is built by Build(geometry, transmittance, threads) and
/// follows by Update(transmittance, threads), e.g. EmbreeAccel.
template <class Accel>
class TracedScene {
 public:
  /// @param scene must outlive this; it is composed by the first GoTo.
  explicit TracedScene(const Scene& scene) : scene_(scene) {}
  TracedScene(const TracedScene&) = delete;  // the accelerator points in
  TracedScene& operator=(const TracedScene&) = delete;

  /// Prepares the scene at that time, from where it was if it was anywhere.
  /// @param threads at most this many; 0 = all cores.
  /// @return an Error after which it is nowhere.
  Status GoTo(double time, int threads) {
    if (accel_ && time_ == time) return {};
    const Status gone = accel_ ? Move(time, threads) : Prepare(time, threads);
    if (!gone) accel_.reset();  // half moved
    time_ = time;
    return gone;
  }

  /// After GoTo.
  const Accel& accel() const { return *accel_; }
  const Geometry& geometry() const { return parts_.geometry; }
  const ShadingScene& shading() const { return parts_.shading; }

 private:
  Status Prepare(double time, int threads) {
    RTB_ASSIGN_OR_RETURN(parts_, PrepareParts(scene_, time));
    RTB_ASSIGN_OR_RETURN(
        Accel accel,
        Accel::Build(parts_.geometry, Transmittances(parts_), threads));
    accel_.emplace(std::move(accel));
    return {};
  }

  Status Move(double time, int threads) {
    RTB_RETURN_IF_ERROR(MoveParts(scene_, time, &parts_));
    return accel_->Update(Transmittances(parts_), threads);
  }

  const Scene& scene_;
  double time_ = 0;
  SceneParts parts_;
  std::optional<Accel> accel_;
};

}  // namespace rtb
