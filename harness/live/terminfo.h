/// @file
/// What terminfo says of a terminal (through ncurses).
#pragma once

#include <string>

#include "core/base/result.h"

namespace rtb {

/// An entry of terminfo.
struct Terminfo {
  std::string name;
  int colors = 0;
  bool direct = false;  ///< Colors are 24-bit values.
  std::string enter;    ///< smcup: to the alternate screen; may be empty.
  std::string leave;    ///< rmcup.
};

/// Reads an entry.
/// @return kBadInput for a terminal that is unknown, or that cannot move its
/// cursor (`dumb`).
Result<Terminfo> ReadTerminfo(const std::string& term);

}  // namespace rtb
