/// @file
/// The line of progress on standard error, for console.cc.
#pragma once

#include <string>

namespace rtb {

/// `12 s`, `3 min`, `2 h 05 min`.
std::string DurationText(double seconds);

/// A bar of `width` characters of which the share is filled: `[####----]`.
std::string BarText(double share, int width);

/// Takes a line of progress off the terminal, so that another can be printed.
/// It comes back when it is next shown.
void ClearProgress();

}  // namespace rtb
