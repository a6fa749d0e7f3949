#include "core/render/bvh_backend.h"

#include "core/accel/bvh_accel.h"
#include "core/render/host_backend.h"

namespace rtb {

Result<std::unique_ptr<Backend>> MakeBvhBackend(const Scene& scene) {
  return std::make_unique<HostBackend<BvhAccel>>("bvh", scene);
}

}  // namespace rtb
