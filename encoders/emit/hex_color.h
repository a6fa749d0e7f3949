/// @file
/// Colors as `#rrggbb`.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/color/srgb.h"

namespace rtb {

/// `#rrggbb` in lowercase.
std::string HexColor(Rgb8 color);

/// Reads `#rrggbb`, in either case.
std::optional<Rgb8> ParseHexColor(std::string_view text);

}  // namespace rtb
