/// @file
/// The identity of a unit: a hash of all that its result depends on.
#pragma once

#include <vector>

#include "harness/sweep/unit.h"

namespace rtb {

/// Sets the hash of each unit: of its configuration, the content of the scene
/// and of the files that it names, of the reference, of the fonts, and of the
/// versions of this program and of the encoder. The commit has no part in it,
/// nor the machine. What cannot be read counts as absent.
void Identify(std::vector<SweepUnit>& units);

}  // namespace rtb
