#include <hwy/highway.h>

#include <bit>

#include "encoders/simd/kernels.h"

namespace rtb {

// Of the supported targets the one with the lowest bit is the best.
const char* SimdTargetName() {
  const auto targets = static_cast<std::uint64_t>(hwy::SupportedTargets());
  return hwy::TargetName(
      static_cast<std::int64_t>(std::uint64_t{1} << std::countr_zero(targets)));
}

}  // namespace rtb
