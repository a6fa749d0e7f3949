/// @file
/// A folder for what passes between two programs.
#pragma once

#include <filesystem>

#include "core/base/result.h"

namespace rtb {

/// A new folder that nobody but its owner may enter, below the system's place
/// for temporary files. It goes, with all that is in it, when this object does.
class ScratchFolder {
 public:
  /// Makes one. @return kFailure when that place is not writable.
  static Result<ScratchFolder> Make();

  ScratchFolder(ScratchFolder&& other) noexcept;
  ScratchFolder& operator=(ScratchFolder&&) = delete;
  ~ScratchFolder();

  const std::filesystem::path& path() const { return path_; }

 private:
  explicit ScratchFolder(std::filesystem::path path) : path_(std::move(path)) {}

  std::filesystem::path path_;  ///< Empty once moved from.
};

}  // namespace rtb
