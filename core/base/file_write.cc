#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cstdio>
#include <optional>
#include <system_error>

#include "core/base/file.h"
#include "core/base/posix.h"

namespace rtb {
namespace {

namespace fs = std::filesystem;

Error WriteError(const fs::path& file, int code) {
  std::string hint;
  if (code == EACCES || code == EPERM || code == EROFS) {
    hint = "choose a place that you may write to";
  } else if (code == ENOSPC || code == EDQUOT) {
    hint = "free some space and run again";
  }
  return Failure(file.string(), "cannot be written: " + ErrnoText(code), hint);
}

/// The descriptor that a path such as /dev/stdout or /dev/fd/3 stands for.
/// Reopening it would lose its offset, and fails for sockets.
std::optional<int> OwnDescriptor(const fs::path& file) {
  if (file == "/dev/stdout") return STDOUT_FILENO;
  if (file == "/dev/stderr") return STDERR_FILENO;
  const fs::path folder = file.parent_path();
  if (folder != "/dev/fd" && folder != "/proc/self/fd") return std::nullopt;
  int fd = 0;
  if (std::sscanf(file.filename().c_str(), "%d", &fd) != 1) return std::nullopt;
  return fd;
}

Status WriteThrough(const fs::path& file, std::string_view bytes) {
  const UniqueFd fd(::open(file.c_str(), O_WRONLY | O_CLOEXEC));
  if (!fd.valid()) return Fail(WriteError(file, errno));
  if (const int code = WriteAll(fd.get(), bytes)) {
    return Fail(WriteError(file, code));
  }
  return {};
}

/// A file beside the target that disappears unless it is renamed over it.
class TemporaryNeighbor {
 public:
  explicit TemporaryNeighbor(const fs::path& target) {
    static std::atomic<unsigned> counter = 0;
    do {
      path_ = target.parent_path() / (".rtbench." + std::to_string(::getpid()) +
                                      "." + std::to_string(counter++) + ".tmp");
      fd_.Reset(
          ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
    } while (!fd_.valid() && errno == EEXIST);
    if (!fd_.valid()) path_.clear();
  }
  TemporaryNeighbor(const TemporaryNeighbor&) = delete;
  TemporaryNeighbor& operator=(const TemporaryNeighbor&) = delete;
  ~TemporaryNeighbor() {
    if (!path_.empty()) ::unlink(path_.c_str());
  }

  bool valid() const { return fd_.valid(); }

  /// @return 0 or an errno value.
  int Fill(std::string_view bytes, std::optional<mode_t> mode) {
    if (mode && ::fchmod(fd_.get(), *mode) != 0) return errno;
    if (const int code = WriteAll(fd_.get(), bytes)) return code;
    return ::fsync(fd_.get()) == 0 ? 0 : errno;
  }

  /// @return 0 or an errno value.
  int RenameOver(const fs::path& target) {
    if (::rename(path_.c_str(), target.c_str()) != 0) return errno;
    path_.clear();
    return 0;
  }

 private:
  fs::path path_;
  UniqueFd fd_;
};

/// Makes a rename last; file systems that cannot are none of our errors.
void SyncFolder(const fs::path& folder) {
  const UniqueFd fd(::open(folder.empty() ? "." : folder.c_str(),
                           O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (fd.valid()) ::fsync(fd.get());
}

Status Replace(const fs::path& target, std::string_view bytes,
               std::optional<mode_t> mode) {
  std::error_code failed;
  if (target.has_parent_path()) {
    fs::create_directories(target.parent_path(), failed);
  }
  if (failed) return Fail(WriteError(target.parent_path(), failed.value()));
  TemporaryNeighbor temporary(target);
  if (!temporary.valid()) return Fail(WriteError(target, errno));
  if (const int code = temporary.Fill(bytes, mode)) {
    return Fail(WriteError(target, code));
  }
  if (const int code = temporary.RenameOver(target)) {
    return Fail(WriteError(target, code));
  }
  SyncFolder(target.parent_path());
  return {};
}

}  // namespace

Status WriteFileAtomically(const fs::path& file, std::string_view bytes) {
  if (!file.has_filename()) {
    return Fail(BadInput(file.string(), "names no file to write"));
  }
  if (const auto fd = OwnDescriptor(file)) {
    const int code = WriteAll(*fd, bytes);
    if (code) return Fail(WriteError(file, code));
    return {};
  }
  struct stat info {};
  if (::stat(file.c_str(), &info) != 0) {
    return Replace(file, bytes, std::nullopt);
  }
  if (S_ISDIR(info.st_mode)) {
    return Fail(BadInput(file.string(), "is a folder, expected a file"));
  }
  if (!S_ISREG(info.st_mode)) return WriteThrough(file, bytes);
  if (::access(file.c_str(), W_OK) != 0) return Fail(WriteError(file, errno));
  // A symbolic link stays; what it points to is replaced.
  std::error_code failed;
  const fs::path target = fs::canonical(file, failed);
  if (failed) return Fail(WriteError(file, failed.value()));
  return Replace(target, bytes, info.st_mode & 07777);
}

}  // namespace rtb
