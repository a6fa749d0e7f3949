/// @file
/// Unit: the piece of a sweep's work that a record answers.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/render/sample_plan.h"

namespace rtb {

/// What a unit combines.
struct UnitConfiguration {
  std::string scene;
  double time = 0;  ///< Seconds along the scene's movement.
  GridSize grid;
  int spp = 1;
  std::string backend;
  std::string integrator;
  std::string color;
  std::string reference;  ///< As asked for; empty = the default choice.
  std::uint64_t seed = 0;
  std::vector<std::string> encoders;  ///< SPECs.
  bool operator==(const UnitConfiguration&) const = default;
};

/// Its identity.
struct Unit {
  std::string kind;   ///< `quality`, `timing`, `temporal` or `live`.
  std::string suite;  ///< The suite's name.
  std::string hash;   ///< Of all that the unit's result depends on.
  UnitConfiguration configuration;
  bool operator==(const Unit&) const = default;
};

}  // namespace rtb
