/// @file
/// Names of files that a session leaves in the current folder.
#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"

namespace rtb {

/// `rtbench-live-001`, or with the first number of which no file with one of
/// the extensions exists.
/// @param extensions with their dots.
Result<std::string> FreeName(const std::vector<std::string>& extensions);

}  // namespace rtb
