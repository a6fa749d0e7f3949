/// @file
/// The accelerators, for typed tests that hold for each of them.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <type_traits>

#include "core/accel/bvh_accel.h"
#include "core/accel/embree_accel.h"

namespace rtb::testing {

using Accels = ::testing::Types<EmbreeAccel, BvhAccel>;

/// Their names in those of the tests.
struct AccelNames {
  template <class Accel>
  static std::string GetName(int) {
    return std::is_same_v<Accel, EmbreeAccel> ? "Embree" : "Bvh";
  }
};

}  // namespace rtb::testing
