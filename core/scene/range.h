/// @file
/// The ranges of numbers that the scene format names.
#pragma once

namespace rtb {

/// An interval of numbers and the words for it in "expected ...".
struct Range {
  double low;
  double high;
  const char* words;
  bool open = false;  ///< The ends themselves are excluded.

  bool Holds(double x) const {
    return open ? low < x && x < high : low <= x && x <= high;
  }
};

/// Rendering is done in single precision: squares of larger lengths, or
/// inverse squares of smaller ones, would leave its range.
inline constexpr double kLargestNumber = 1e18;
inline constexpr double kSmallestPositive = 1e-18;

inline constexpr Range kAnyNumber{-kLargestNumber, kLargestNumber,
                                  "a number of magnitude at most 1e18"};
inline constexpr Range kPositive{kSmallestPositive, kLargestNumber,
                                 "a number greater than 0 (1e-18 to 1e18)"};
inline constexpr Range kNonNegative{0, kLargestNumber,
                                    "a number from 0 up (to 1e18)"};
inline constexpr Range kUnitRange{0, 1, "a number within 0..1"};
inline constexpr Range kIor{1, 4, "a number within 1..4"};
inline constexpr Range kFieldOfView{
    0, 180, "an angle between 0 and 180 degrees, both excluded", true};
inline constexpr Range kConeAngle{
    kSmallestPositive, 90, "an angle greater than 0, at most 90 degrees"};
inline constexpr Range kRightAngle{0, 90, "an angle within 0..90 degrees"};
/// So that 2^exposure stays within single precision.
inline constexpr Range kStops{-100, 100, "a number of stops within -100..100"};

}  // namespace rtb
