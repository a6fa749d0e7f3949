#include "core/base/manifest.h"

#include <sched.h>
#include <sys/utsname.h>

#include <cstdlib>
#include <ctime>
#include <fstream>
#include <string_view>
#include <thread>

namespace rtb {
namespace {

#include "build_info.inc"
#include "commit.inc"

constexpr char kUnknown[] = "unknown";

/// What follows `key`, blanks and `separator` on the first line of a file that
/// begins with them, without quotation marks.
std::string ValueIn(const char* file, std::string_view key, char separator) {
  std::ifstream lines(file);
  for (std::string line; std::getline(lines, line);) {
    if (line.compare(0, key.size(), key) != 0) continue;
    const auto at = line.find(separator);
    if (at == std::string::npos) continue;
    const auto first = line.find_first_not_of(" \t\"", at + 1);
    if (first == std::string::npos) continue;
    return line.substr(first, line.find_last_not_of(" \t\"") + 1 - first);
  }
  return kUnknown;
}

int UsableCores() {
  cpu_set_t set;
  CPU_ZERO(&set);
  if (::sched_getaffinity(0, sizeof set, &set) == 0) return CPU_COUNT(&set);
  return static_cast<int>(std::thread::hardware_concurrency());
}

}  // namespace

BuildInfo GetBuildInfo() {
  BuildInfo info;
  info.version = kVersion;
  info.commit = kCommit;
  info.dirty = kDirty;
  info.build_type = kBuildType;
  info.compiler = kCompiler;
  info.flags = kFlags;
  return info;
}

HostInfo GetHostInfo() {
  HostInfo info;
  info.cpu_model = ValueIn("/proc/cpuinfo", "model name", ':');
  info.cores = UsableCores();
  info.os = ValueIn("/etc/os-release", "PRETTY_NAME", '=');
  utsname names{};
  const bool named = ::uname(&names) == 0;
  info.kernel =
      named ? std::string(names.sysname) + " " + names.release : kUnknown;
  info.hostname = named ? names.nodename : kUnknown;
  if (::getloadavg(&info.load_1min, 1) != 1) info.load_1min = 0;
  return info;
}

std::string UtcNow() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  ::gmtime_r(&now, &parts);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &parts);
  return text;
}

}  // namespace rtb
