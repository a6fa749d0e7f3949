#include "harness/live/live_view.h"

#include <tuple>

namespace rtb {
namespace {

bool SameCamera(const std::optional<CameraFrame>& a,
                const std::optional<CameraFrame>& b) {
  if (!a || !b) return !a && !b;
  return a->position == b->position && a->right == b->right && a->up == b->up &&
         a->forward == b->forward && a->tan_half_vfov == b->tan_half_vfov;
}

auto SampleKey(const LiveView& v) {
  return std::tie(v.scene, v.backend, v.integrator, v.split, v.divider, v.grid,
                  v.cell_aspect, v.spp, v.max_depth, v.time, v.exposure,
                  v.seed);
}

}  // namespace

bool SameSamples(const LiveView& a, const LiveView& b) {
  return SampleKey(a) == SampleKey(b) && SameCamera(a.camera, b.camera);
}

bool SamePicture(const LiveView& a, const LiveView& b) {
  return SameSamples(a, b) && a.encoders == b.encoders && a.depth == b.depth &&
         a.temporal == b.temporal;
}

}  // namespace rtb
