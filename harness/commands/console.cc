#include "harness/commands/console.h"

#include <fcntl.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>

#include "core/base/file.h"
#include "core/base/posix.h"
#include "harness/commands/progress.h"

namespace rtb {
namespace {

/// Opens /dev/null so that using the descriptor goes on failing.
void Occupy(int descriptor, int mode) {
  if (::fcntl(descriptor, F_GETFD) == -1) ::open("/dev/null", mode);
}

}  // namespace

void PrepareConsole() {
  std::signal(SIGPIPE, SIG_IGN);
  Occupy(STDIN_FILENO, O_WRONLY);
  Occupy(STDOUT_FILENO, O_RDONLY);
  Occupy(STDERR_FILENO, O_RDONLY);
}

void PrintError(const Error& error) {
  ClearProgress();
  const bool red = ::isatty(STDERR_FILENO) != 0 && !ColorsUnwanted();
  WriteToStderr((red ? "\033[31mrtbench:\033[0m " : "rtbench: ") +
                error.ToString() + "\n");
}

void PrintNote(const std::string& text) {
  ClearProgress();
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

std::vector<std::string> CommandLine() {
  const auto bytes = ReadFile("/proc/self/cmdline");
  std::vector<std::string> words;
  if (!bytes) return words;
  for (std::size_t begin = 0; begin < bytes->size();) {
    words.emplace_back(bytes->c_str() + begin);
    begin += words.back().size() + 1;
  }
  return words;
}

}  // namespace rtb
