/// @file
/// EyeSample: an eye ray and the random numbers that belong to it.
#pragma once

#include <cstdint>

#include "core/accel/ray.h"
#include "core/shading/ray_cone.h"

namespace rtb {

/// One of the rays of a sample. An integrator draws point `index` of patterns
/// that are functions of `pattern` and `seed`, so that a sample's rays
/// together are well distributed.
struct EyeSample {
  Ray ray;
  RayCone cone;               ///< Of what the ray stands for.
  std::uint32_t pattern = 0;  ///< Of the sample: a hash of cell and number.
  std::uint32_t index = 0;    ///< Of the ray among the sample's.
  std::uint64_t seed = 0;     ///< The rendering's.
};

}  // namespace rtb
