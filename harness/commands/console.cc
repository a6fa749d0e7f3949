#include "harness/commands/console.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>

#include "core/base/file.h"

namespace rtb {
namespace {

/// Opens /dev/null so that using the descriptor goes on failing.
void Occupy(int descriptor, int mode) {
  if (::fcntl(descriptor, F_GETFD) == -1) ::open("/dev/null", mode);
}

/// Writes all bytes to a descriptor, whatever it is (file, pipe, terminal).
bool WriteAll(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
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
  if (WriteAll(STDOUT_FILENO, bytes)) return {};
  return Fail(Failure("standard output", std::strerror(errno)));
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
  char buffer[1 << 16];
  while (true) {
    const ssize_t got = ::read(STDIN_FILENO, buffer, sizeof buffer);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return Fail(Failure("standard input", std::strerror(errno)));
    if (got == 0) return bytes;
    bytes.append(buffer, static_cast<std::size_t>(got));
    if (bytes.size() > kLimit) {
      return Fail(BadInput("standard input", "more than 1 GiB"));
    }
  }
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
