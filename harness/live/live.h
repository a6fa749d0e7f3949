/// @file
/// The live mode in the user's terminal.
#pragma once

#include <string>

#include "core/base/result.h"
#include "harness/live/live_request.h"

namespace rtb {

/// Runs a session until somebody quits.
/// @return the signal that ended it, to be raised again; 0 for none.
Result<int> RunLive(const LiveRequest& request);

/// What the terminal answered, and what follows from it, line by line.
Result<std::string> DescribeTerminal(const LiveRequest& request);

}  // namespace rtb
