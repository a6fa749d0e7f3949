#include "core/render/embree_backend.h"

#include "core/accel/embree_accel.h"
#include "core/render/host_backend.h"

namespace rtb {

Result<std::unique_ptr<Backend>> MakeEmbreeBackend(const Scene& scene) {
  return std::make_unique<HostBackend<EmbreeAccel>>("embree", scene);
}

}  // namespace rtb
