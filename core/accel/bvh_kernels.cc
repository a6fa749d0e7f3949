#include "core/accel/bvh_kernels.h"

#include <array>

#include "core/accel/bvh_lanes_avx2.h"

namespace rtb {
namespace {

Hit ClosestPortable(const BvhView& view, const Ray& ray) {
  return ClosestInBvh<PortableLanes>(view, ray);
}

void CrossPortable(const BvhView& view, const Ray& ray, BvhCrossing* crossing) {
  CrossBvh<PortableLanes>(view, ray, crossing);
}

#ifdef __x86_64__
// Inlines the whole walk, so that the tests become part of it and all is
// compiled for the instruction set. Sanitizers make that too large.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define RTB_AVX2_WALK RTB_AVX2
#else
#define RTB_AVX2_WALK RTB_AVX2 [[gnu::flatten]]
#endif

RTB_AVX2_WALK Hit ClosestAvx2(const BvhView& view, const Ray& ray) {
  return ClosestInBvh<Avx2Lanes>(view, ray);
}

RTB_AVX2_WALK void CrossAvx2(const BvhView& view, const Ray& ray,
                             BvhCrossing* crossing) {
  CrossBvh<Avx2Lanes>(view, ray, crossing);
}
#endif

constexpr std::array kKernels = {
    BvhKernels{"portable", ClosestPortable, CrossPortable},
#ifdef __x86_64__
    BvhKernels{"avx2", ClosestAvx2, CrossAvx2},
#endif
};

/// How many of them the processor can run.
std::size_t RunnableCount() {
#ifdef __x86_64__
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("bmi")) return 2;
#endif
  return 1;
}

}  // namespace

std::span<const BvhKernels> RunnableBvhKernels() {
  static const std::size_t count = RunnableCount();
  return std::span(kKernels).first(count);
}

}  // namespace rtb
