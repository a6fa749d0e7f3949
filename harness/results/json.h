/// @file
/// The JSON that records are made of.
#pragma once

#include <nlohmann/json.hpp>

namespace rtb {

/// JSON whose keys keep their order, so that equal data gives equal bytes.
using Json = nlohmann::ordered_json;

}  // namespace rtb
