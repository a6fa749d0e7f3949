/// @file
/// Stratified sample positions on the unit square.
#pragma once

#include <cstdint>

#include "core/math/vec.h"

namespace rtb {

/// Position `index` of `count` correlated multi-jittered samples of the unit
/// square: stratified in two dimensions and in each of them, for any count.
/// Kensler, "Correlated Multi-Jittered Sampling", Pixar TM 13-01, 2013,
/// listing 4 (arbitrary sample counts).
/// @param pattern selects one of 2^32 patterns.
V2f MultiJittered(std::uint32_t index, std::uint32_t count,
                  std::uint32_t pattern);

}  // namespace rtb
