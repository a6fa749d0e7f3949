/// @file
/// RunFailure: why a unit of work has no result.
#pragma once

#include <string>

namespace rtb {

/// An Error, as records keep it.
struct RunFailure {
  std::string kind;     ///< `failed`, or `skipped` where something is missing.
  std::string encoder;  ///< SPEC of the one that failed; empty = none did.
  std::string place;
  std::string what;
  std::string hint;
  bool operator==(const RunFailure&) const = default;
};

}  // namespace rtb
