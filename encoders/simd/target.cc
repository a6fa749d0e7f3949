#include <hwy/highway.h>

#include <bit>

#include "encoders/simd/kernels.h"

namespace rtb {

// Of the targets that the processor supports and this program holds, the one
// with the lowest bit is the best.
const char* SimdTargetName() {
  const auto targets =
      static_cast<std::uint64_t>(hwy::SupportedTargets() & HWY_TARGETS);
  return hwy::TargetName(
      static_cast<std::int64_t>(std::uint64_t{1} << std::countr_zero(targets)));
}

}  // namespace rtb
