#include "core/base/scratch_folder.h"

#include <stdlib.h>

#include <string>
#include <system_error>
#include <utility>

#include "core/base/posix.h"

namespace rtb {

namespace fs = std::filesystem;

Result<ScratchFolder> ScratchFolder::Make() {
  std::error_code failed;
  const fs::path parent = fs::temp_directory_path(failed);
  if (failed) {
    return Fail(Failure("TMPDIR", "is no folder: " + failed.message()));
  }
  std::string name = (parent / "rtbench_XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) {  // Mode 0700.
    return Fail(Failure(parent.string(), "no temporary folder: " + ErrnoText(),
                        "set TMPDIR to a writable folder"));
  }
  return ScratchFolder(name);
}

ScratchFolder::ScratchFolder(ScratchFolder&& other) noexcept
    : path_(std::exchange(other.path_, {})) {}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  if (!path_.empty()) fs::remove_all(path_, ignored);
}

}  // namespace rtb
