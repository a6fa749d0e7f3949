/// @file
/// A child process in a process group of its own, with pipes to its output.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/posix.h"
#include "core/base/result.h"

namespace rtb {

/// A running child. Whoever lets go of it early kills its whole group; it
/// never stays behind as a zombie.
class Child {
 public:
  /// Starts a program; its standard input is empty.
  /// @param program full path; @param argv includes the program's name.
  /// @param directory working directory; empty = ours.
  /// @param environment `NAME=value`s that replace ours of the same names.
  static Result<Child> Start(const std::filesystem::path& program,
                             const std::vector<std::string>& argv,
                             const std::filesystem::path& directory,
                             const std::vector<std::string>& environment);

  Child(Child&& other) noexcept;
  Child& operator=(Child&&) = delete;
  ~Child();

  UniqueFd& out() { return out_; }
  UniqueFd& err() { return err_; }

  /// Whether it has ended; then it is reaped. Waits for that if `block`.
  bool Ended(bool block);
  /// Its exit status, or 128 + the signal that ended it. Needs Ended().
  int ExitStatus() const;

 private:
  Child(pid_t pid, UniqueFd out, UniqueFd err);

  pid_t pid_;
  UniqueFd out_;
  UniqueFd err_;
  int status_ = 0;
};

}  // namespace rtb
