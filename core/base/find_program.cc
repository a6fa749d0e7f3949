#include <unistd.h>

#include <cstdlib>
#include <sstream>
#include <system_error>

#include "core/base/process.h"

namespace rtb {
namespace {

namespace fs = std::filesystem;

std::optional<fs::path> IfExecutable(const fs::path& file) {
  std::error_code failed;
  if (!fs::is_regular_file(file, failed)) return std::nullopt;
  if (::access(file.c_str(), X_OK) != 0) return std::nullopt;
  const fs::path full = fs::absolute(file, failed);
  if (failed) return std::nullopt;
  return full;
}

}  // namespace

std::optional<fs::path> FindProgram(const std::string& name) {
  if (name.empty()) return std::nullopt;
  if (name.find('/') != std::string::npos) return IfExecutable(name);
  const char* folders = std::getenv("PATH");
  std::istringstream list(folders ? folders : "/usr/bin:/bin");
  for (std::string folder; std::getline(list, folder, ':');) {
    // POSIX: an empty entry is the current folder.
    const auto found =
        IfExecutable(fs::path(folder.empty() ? "." : folder) / name);
    if (found) return found;
  }
  return std::nullopt;
}

}  // namespace rtb
