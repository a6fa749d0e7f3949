#include "core/base/spawn.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <string_view>
#include <utility>

namespace rtb {
namespace {

/// A pipe; neither end outlives an exec unless it is handed over.
struct Pipe {
  UniqueFd read, write;

  bool Open() {
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0) return false;
    read.Reset(ends[0]);
    write.Reset(ends[1]);
    return true;
  }
};

/// For exec: the texts, and a null pointer behind them.
std::vector<char*> Pointers(const std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  for (const std::string& text : texts) {
    pointers.push_back(const_cast<char*>(text.c_str()));
  }
  pointers.push_back(nullptr);
  return pointers;
}

/// Our environment, but for variables that `replacing` sets.
std::vector<std::string> Environment(
    const std::vector<std::string>& replacing) {
  const auto name = [](std::string_view variable) {
    return variable.substr(0, variable.find('='));
  };
  std::vector<std::string> all = replacing;
  for (char** ours = environ; *ours != nullptr; ++ours) {
    const bool replaced = std::ranges::any_of(
        replacing,
        [&](const std::string& other) { return name(other) == name(*ours); });
    if (!replaced) all.emplace_back(*ours);
  }
  return all;
}

/// What the child does between its birth and the program's start.
class SpawnPlan {
 public:
  SpawnPlan() {
    ::posix_spawn_file_actions_init(&actions_);
    ::posix_spawnattr_init(&attributes_);
  }
  SpawnPlan(const SpawnPlan&) = delete;
  SpawnPlan& operator=(const SpawnPlan&) = delete;
  ~SpawnPlan() {
    ::posix_spawn_file_actions_destroy(&actions_);
    ::posix_spawnattr_destroy(&attributes_);
  }

  void Redirect(const Pipe& out, const Pipe& err) {
    ::posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null",
                                       O_RDONLY, 0);
    ::posix_spawn_file_actions_adddup2(&actions_, out.write.get(),
                                       STDOUT_FILENO);
    ::posix_spawn_file_actions_adddup2(&actions_, err.write.get(),
                                       STDERR_FILENO);
  }

  void ChangeFolder(const std::filesystem::path& folder) {
    ::posix_spawn_file_actions_addchdir_np(&actions_, folder.c_str());
  }

  /// A group of its own, no blocked signals, and SIGPIPE as programs expect
  /// it, whatever we do with it.
  void IsolateSignals() {
    sigset_t none, defaults;
    sigemptyset(&none);
    sigemptyset(&defaults);
    sigaddset(&defaults, SIGPIPE);
    ::posix_spawnattr_setsigmask(&attributes_, &none);
    ::posix_spawnattr_setsigdefault(&attributes_, &defaults);
    ::posix_spawnattr_setpgroup(&attributes_, 0);
    ::posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETPGROUP |
                                                 POSIX_SPAWN_SETSIGMASK |
                                                 POSIX_SPAWN_SETSIGDEF);
  }

  /// @return 0 or an errno value, also for what fails inside the child.
  int Spawn(const std::filesystem::path& program,
            const std::vector<std::string>& argv,
            const std::vector<std::string>& environment, pid_t* pid) const {
    return ::posix_spawn(pid, program.c_str(), &actions_, &attributes_,
                         Pointers(argv).data(), Pointers(environment).data());
  }

 private:
  posix_spawn_file_actions_t actions_;
  posix_spawnattr_t attributes_;
};

}  // namespace

Result<Child> Child::Start(const std::filesystem::path& program,
                           const std::vector<std::string>& argv,
                           const std::filesystem::path& directory,
                           const std::vector<std::string>& environment) {
  Pipe out, err;
  if (!out.Open() || !err.Open()) {
    return Fail(Failure(program.string(), "no pipe: " + ErrnoText()));
  }
  SpawnPlan plan;
  plan.Redirect(out, err);
  plan.IsolateSignals();
  if (!directory.empty()) plan.ChangeFolder(directory);
  pid_t pid = -1;
  if (const int code =
          plan.Spawn(program, argv, Environment(environment), &pid)) {
    return Fail(
        Failure(program.string(), "cannot be started: " + ErrnoText(code)));
  }
  return Child(pid, std::move(out.read), std::move(err.read));
}

Child::Child(pid_t pid, UniqueFd out, UniqueFd err)
    : pid_(pid), out_(std::move(out)), err_(std::move(err)) {}

Child::Child(Child&& other) noexcept
    : pid_(std::exchange(other.pid_, -1)),
      out_(std::move(other.out_)),
      err_(std::move(other.err_)),
      status_(other.status_) {}

Child::~Child() {
  if (pid_ < 0) return;
  ::kill(-pid_, SIGKILL);
  Ended(true);
}

bool Child::Ended(bool block) {
  while (pid_ >= 0) {
    const pid_t got = ::waitpid(pid_, &status_, block ? 0 : WNOHANG);
    if (got == 0) return false;
    if (got < 0 && errno == EINTR) continue;
    pid_ = -1;
  }
  return true;
}

int Child::ExitStatus() const {
  return WIFSIGNALED(status_) ? 128 + WTERMSIG(status_) : WEXITSTATUS(status_);
}

}  // namespace rtb
