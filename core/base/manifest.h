/// @file
/// The manifest: what program, compiler and machine produced a result.
#pragma once

#include <string>

namespace rtb {

/// How this program was built.
struct BuildInfo {
  std::string version;     ///< Of the project, semantic.
  std::string commit;      ///< Full hash, or "unknown".
  bool dirty = false;      ///< Uncommitted changes at build time.
  std::string build_type;  ///< CMake's: Release, Debug...
  std::string compiler;    ///< Name and version.
  std::string flags;       ///< Compile flags.
};

/// The machine it runs on.
struct HostInfo {
  std::string cpu_model;
  int cores = 0;       ///< Hardware threads that this process may use.
  std::string os;      ///< Pretty name of the distribution.
  std::string kernel;  ///< Name and release.
  std::string hostname;
  double load_1min = 0;  ///< Load average when asked.
};

BuildInfo GetBuildInfo();
HostInfo GetHostInfo();

/// Now, as `2026-01-31T12:34:56Z`.
std::string UtcNow();

}  // namespace rtb
