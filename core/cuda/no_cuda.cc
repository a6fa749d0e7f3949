// Stands in for the CUDA backend where it is not compiled in.
#include "core/render/cuda_backend.h"

namespace rtb {

bool CudaIsCompiledIn() { return false; }

Status CudaRuns() {
  return Fail(Missing("--backend=cuda", "this program was built without CUDA",
                      "build it with nvcc: scripts/build --preset=cuda"));
}

Result<std::string> CudaDeviceName() { return Fail(CudaRuns().error()); }

Result<std::unique_ptr<AheadBackend>> MakeCudaBackend(const Scene& /*scene*/) {
  return Fail(CudaRuns().error());
}

}  // namespace rtb
