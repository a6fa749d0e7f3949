#include "core/accel/bvh_kernels.h"

#include <array>

#include "core/accel/bvh_lanes_avx2.h"
#include "core/accel/bvh_tracer.h"

namespace rtb {
namespace {

#define RTB_BVH_KERNELS(Lanes, attributes)                                   \
  attributes Hit Closest##Lanes(const BvhView& view, const Ray& ray) {       \
    return BasicBvhTracer<Lanes>(view).Closest(ray);                         \
  }                                                                          \
  attributes bool Occluded##Lanes(const BvhView& view, const Ray& ray) {     \
    return BasicBvhTracer<Lanes>(view).Occluded(ray);                        \
  }                                                                          \
  attributes Rgb Transmittance##Lanes(const BvhView& view, const Ray& ray) { \
    return BasicBvhTracer<Lanes>(view).Transmittance(ray);                   \
  }

// `flatten` inlines the whole walk, so that the tests become part of it and
// all is compiled for the instruction set.
RTB_BVH_KERNELS(PortableLanes, [[gnu::flatten]])
#ifdef __x86_64__
RTB_BVH_KERNELS(Avx2Lanes, RTB_AVX2 [[gnu::flatten]])
#endif

constexpr std::array kKernels = {
    BvhKernels{"portable", ClosestPortableLanes, OccludedPortableLanes,
               TransmittancePortableLanes},
#ifdef __x86_64__
    BvhKernels{"avx2", ClosestAvx2Lanes, OccludedAvx2Lanes,
               TransmittanceAvx2Lanes},
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
