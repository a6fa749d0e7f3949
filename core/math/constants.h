/// @file
/// Numbers that everybody uses.
#pragma once

namespace rtb {

inline constexpr float kPi = 3.14159265358979324f;

}  // namespace rtb
