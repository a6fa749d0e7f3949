/// @file
/// Running another program.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace rtb {

/// A program to run; no shell is involved.
struct ProcessOptions {
  std::vector<std::string> argv;    ///< Program (looked up on PATH) first.
  std::filesystem::path directory;  ///< Working directory; empty = ours.
  double timeout_seconds = 0;       ///< 0 = none; past it the child's whole
                                    ///< process group is killed.
  /// `NAME=value`s that replace ours of the same names.
  std::vector<std::string> environment = {};
};

/// What became of it.
struct ProcessResult {
  int exit_status = 0;  ///< 128 + signal when a signal ended it.
  std::string out;      ///< Its standard output.
  std::string err;      ///< Its standard error.
};

/// Runs a program to its end, standard input closed.
/// @return kMissing when it cannot be found, kFailure on timeout.
Result<ProcessResult> RunProcess(const ProcessOptions& options);

/// The full path of a program on PATH, if there.
std::optional<std::filesystem::path> FindProgram(const std::string& name);

}  // namespace rtb
