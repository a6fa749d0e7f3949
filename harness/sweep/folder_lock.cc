/// @file
/// The lock that tells the processes in a sweep's folder of one another.
#include <fcntl.h>
#include <sys/file.h>

#include <system_error>

#include "harness/sweep/folder.h"

namespace rtb {
namespace {

namespace fs = std::filesystem;

/// Whether a name is one of WriteFileAtomically's on the way.
bool IsTemporary(const std::string& name) {
  return name.starts_with(".rtbench.") && name.ends_with(".tmp");
}

/// The unit in the name of a picture, `KIND-HASH.N.flip.jpg`.
std::string UnitIn(const std::string& picture) {
  return picture.substr(0, picture.find('.'));
}

/// The names in a folder.
std::vector<std::string> NamesIn(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    names.push_back(entry.path().filename().string());
  }
  return names;
}

}  // namespace

Status SweepFolder::Lock() {
  const fs::path file = folder_ / ".lock";
  lock_.Reset(::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666));
  if (!lock_.valid()) {
    return Fail(Failure(file.string(), "cannot be written: " + ErrnoText(),
                        "choose a place that you may write to"));
  }
  // Alone here: what looks unfinished is a killed process's. File systems
  // without locks keep such leftovers.
  if (::flock(lock_.get(), LOCK_EX | LOCK_NB) == 0) RemoveLeftovers();
  static_cast<void>(::flock(lock_.get(), LOCK_SH));
  return {};
}

void SweepFolder::RemoveLeftovers() const {
  std::error_code ignored;
  for (const char* part : {"", "units", "pictures"}) {
    const fs::path folder = folder_ / part;
    for (const std::string& name : NamesIn(folder)) {
      if (IsTemporary(name)) fs::remove(folder / name, ignored);
    }
  }
  // Pictures of units whose record did not come to be written.
  for (const std::string& name : NamesIn(folder_ / "pictures")) {
    const std::string unit = UnitIn(name);
    if (!FindUnitKind(unit.substr(0, unit.find('-')))) continue;
    if (!fs::exists(folder_ / "units" / (unit + ".json"), ignored)) {
      fs::remove(folder_ / "pictures" / name, ignored);
    }
  }
}

}  // namespace rtb
