#include "harness/measure/cache.h"

#include <charconv>
#include <cstdlib>

#include "core/base/file.h"
#include "core/base/manifest.h"

namespace rtb {
namespace {

std::string Environment(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr ? value : "";
}

std::string IdentifyProgram() {
  const BuildInfo build = GetBuildInfo();
  std::string identity = build.version + " " + build.commit + " " +
                         build.build_type + " " + build.compiler + " " +
                         build.flags;
  if (build.dirty || build.commit == "unknown") {
    const auto own = Sha256File("/proc/self/exe");
    identity += own ? " " + *own : "";
  }
  return identity;
}

}  // namespace

std::filesystem::path CacheFolder(const std::string& rtbench_cache,
                                  const std::string& xdg_cache_home,
                                  const std::string& home) {
  const std::filesystem::path own = "rtbench";
  if (!rtbench_cache.empty()) return rtbench_cache;
  if (!xdg_cache_home.empty()) return xdg_cache_home / own;
  if (!home.empty()) return std::filesystem::path(home) / ".cache" / own;
  return {};
}

std::filesystem::path CacheFolder() {
  return CacheFolder(Environment("RTBENCH_CACHE"),
                     Environment("XDG_CACHE_HOME"), Environment("HOME"));
}

std::string CacheName(const std::string& kind, const std::string& inputs,
                      const std::string& extension) {
  constexpr std::size_t kDigits = 32;
  return kind + "-" + Sha256(inputs).substr(0, kDigits) + extension;
}

const std::string& ProgramIdentity() {
  static const std::string identity = IdentifyProgram();
  return identity;
}

std::string ExactText(double value) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof(text), value).ptr;
  return {text, end};
}

}  // namespace rtb
