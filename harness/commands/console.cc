#include "harness/commands/console.h"

#include <fcntl.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <memory>

#include "core/base/file.h"
#include "core/base/posix.h"

namespace rtb {
namespace {

/// Opens /dev/null so that using the descriptor goes on failing.
void Occupy(int descriptor, int mode) {
  if (::fcntl(descriptor, F_GETFD) == -1) ::open("/dev/null", mode);
}

/// A share in percent, rewritten in place on a terminal. Elsewhere a line
/// every ten seconds, so that short jobs leave nothing in a log.
class Progress {
 public:
  Progress() = default;
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress() {
    if (open_) WriteToStderr("\n");
  }

  void Show(double share, const std::string& what) {
    const auto now = std::chrono::steady_clock::now();
    if (now - last_ < (in_place_ ? kRefresh : kLogged)) return;
    last_ = now;
    const std::string text = Printable(what) + " " +
                             std::to_string(static_cast<int>(share * 100)) +
                             " %";
    WriteToStderr(in_place_ ? "\r\033[K" + text : text + "\n");
    open_ = in_place_;
  }

 private:
  static constexpr std::chrono::milliseconds kRefresh{100};
  static constexpr std::chrono::milliseconds kLogged{10000};
  bool in_place_ = ::isatty(STDERR_FILENO) != 0;
  bool open_ = false;
  std::chrono::steady_clock::time_point last_ =
      std::chrono::steady_clock::now();
};

}  // namespace

void PrepareConsole() {
  std::signal(SIGPIPE, SIG_IGN);
  Occupy(STDIN_FILENO, O_WRONLY);
  Occupy(STDOUT_FILENO, O_RDONLY);
  Occupy(STDERR_FILENO, O_RDONLY);
}

void PrintError(const Error& error) {
  const bool red = ::isatty(STDERR_FILENO) != 0 && !ColorsUnwanted();
  WriteToStderr((red ? "\033[31mrtbench:\033[0m " : "rtbench: ") +
                error.ToString() + "\n");
}

void PrintNote(const std::string& text) {
  WriteToStderr("rtbench: " + Printable(text) + "\n");
}

Status WriteOutput(const std::string& target, std::string_view bytes) {
  if (target != "-") return WriteFileAtomically(target, bytes);
  const int error = WriteAll(STDOUT_FILENO, bytes);
  if (error == 0) return {};
  return Fail(Failure("standard output", ErrnoText(error)));
}

Status WriteJson(const std::string& target, const Json& json) {
  return WriteOutput(
      target, json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

void WriteToStderr(std::string_view bytes) {
  static_cast<void>(WriteAll(STDERR_FILENO, bytes));
}

Result<std::string> ReadStandardInput() {
  constexpr std::size_t kLimit = std::size_t{1} << 30;
  std::string bytes;
  const int error = ReadAll(STDIN_FILENO, kLimit + 1, &bytes);
  if (error != 0) return Fail(Failure("standard input", ErrnoText(error)));
  if (bytes.size() <= kLimit) return bytes;
  return Fail(BadInput("standard input", "more than 1 GiB"));
}

bool OutputIsTerminal() { return ::isatty(STDOUT_FILENO) != 0; }

bool ColorsUnwanted() {
  const char* value = std::getenv("NO_COLOR");
  return value != nullptr && *value != '\0';
}

std::function<void(double, const std::string&)> ProgressLine(bool quiet) {
  if (quiet) return [](double, const std::string&) {};
  return
      [line = std::make_shared<Progress>()](
          double share, const std::string& what) { line->Show(share, what); };
}

}  // namespace rtb
