/// @file
/// Which points of a light, or of a rough lobe, the Whitted integrator takes.
/// Host and device.
#pragma once

#include <cstdint>

#include "core/base/host_device.h"
#include "core/math/sampling.h"
#include "core/math/sobol.h"
#include "core/render/eye_sample.h"

namespace rtb {

/// `count` stratified points of the unit square at one hit: a run of a Sobol
/// sequence, well distributed over all runs of a sample too, where its
/// length is a power of two; else correlated multi-jittered points.
class StratifiedPoints {
 public:
  /// @param run which run of `count`: siblings that go through one pattern
  ///     together have one each.
  /// @param branch, purpose tell the patterns of one sample apart.
  RTB_HD StratifiedPoints(const EyeSample& eye, std::uint32_t run,
                          std::uint32_t branch, std::uint32_t purpose,
                          int count)
      : count_(static_cast<std::uint32_t>(count)),
        first_(run * count_),
        sobol_((count_ & (count_ - 1)) == 0),
        seed_(
            SobolSeed(eye.pattern, PatternHash(branch, purpose, 6), eye.seed)) {
    if (!sobol_) seed_ = PatternHash(run, seed_, 5);
  }

  RTB_HD V2f At(int k) const {
    const auto i = static_cast<std::uint32_t>(k);
    return sobol_ ? SobolOwen2(first_ + i, seed_)
                  : MultiJittered(i, count_, seed_);
  }

 private:
  std::uint32_t count_;
  std::uint32_t first_;
  bool sobol_;
  std::uint32_t seed_;
};

}  // namespace rtb
