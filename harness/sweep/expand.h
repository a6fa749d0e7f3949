/// @file
/// From a suite to its units. Pure: no file is read.
#pragma once

#include <vector>

#include "harness/sweep/suite.h"
#include "harness/sweep/unit.h"

namespace rtb {

/// All units of a suite, each once, without hashes. Those whose times count
/// stand after all others; among each of the two, the units of a scene stand
/// together, scenes in the suite's order; within a scene the order is that of
/// the product.
std::vector<SweepUnit> Expand(const Suite& suite);

/// Whether anything about a run depends on its seed.
bool DependsOnSeed(const std::string& encoder, int spp,
                   const std::string& integrator);

}  // namespace rtb
