/// @file
/// Reading the values of encoder parameters, for the plug-ins' factories.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/base/result.h"
#include "encoders/registry.h"

namespace rtb {

/// The value given for a parameter, or its default.
const std::string& ValueOf(const EncoderParameter& parameter,
                           const EncoderParameters& given);

/// For a parameter whose `values` read `a|b|c`: which of them was chosen, as
/// an index. An enum in the order of the values is one static_cast away.
/// @return kBadInput that lists the values.
Result<int> ReadChoice(const EncoderParameter& parameter,
                       const EncoderParameters& given);

/// A number in [low, high].
/// @return kBadInput that says so.
Result<double> ReadNumber(const EncoderParameter& parameter,
                          const EncoderParameters& given, double low,
                          double high);

/// The parameter `seed`, of encoders that place samples at random.
const EncoderParameter& SeedParameter();

/// The given seed; none where it is the run's.
Result<std::optional<std::uint64_t>> ReadSeed(const EncoderParameters& given);

/// The names in `a|b|c`.
std::vector<std::string> ChoiceNames(const EncoderParameter& parameter);

}  // namespace rtb
