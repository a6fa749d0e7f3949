/// @file
/// How likely next-event estimation is to choose each of a scene's emitters.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace rtb {

/// Weights of choice, for MakeCdf: half of it goes by power, half to all that
/// shine alike - each declared light, the background, and the emissive objects
/// as one - since what has little power may be what is near. What has no
/// power has no weight.
/// @param powers of the declared lights, then of emissive objects, last of the
///     background; finite and not negative.
/// @param declared the number of declared lights.
std::vector<double> ChoiceWeights(std::span<const double> powers,
                                  std::size_t declared);

}  // namespace rtb
