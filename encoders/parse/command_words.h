/// @file
/// A command line as words, without a shell.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace rtb {

/// Splits at blanks as a POSIX shell would (XCU 2.2): '...' is taken as it
/// stands, in "..." a backslash quotes \ and ", elsewhere it quotes any
/// character. Nothing is expanded: $, * and ; are characters like others.
/// @return kBadInput for quotes that are not closed.
Result<std::vector<std::string>> CommandWords(std::string_view command);

}  // namespace rtb
