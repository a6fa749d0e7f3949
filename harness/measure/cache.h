/// @file
/// The cache of what is costly to compute and depends on nothing but its
/// inputs: files named by a hash of these.
#pragma once

#include <filesystem>
#include <string>

namespace rtb {

/// The cache folder of environment values (empty = unset): RTBENCH_CACHE, else
/// `rtbench` in XDG_CACHE_HOME, else in `.cache` of HOME, else empty: there is
/// none.
std::filesystem::path CacheFolder(const std::string& rtbench_cache,
                                  const std::string& xdg_cache_home,
                                  const std::string& home);

/// The same of this process's environment.
std::filesystem::path CacheFolder();

/// `kind-HASH.extension` for inputs spelled out as text, every one of them.
std::string CacheName(const std::string& kind, const std::string& inputs,
                      const std::string& extension);

/// What results of this program depend on beside their inputs: version and
/// commit, and where there were uncommitted changes the program's own hash.
const std::string& ProgramIdentity();

/// A number as it is spelled in the inputs of CacheName, exactly.
std::string ExactText(double value);

}  // namespace rtb
