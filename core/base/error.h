/// @file
/// The one error type that travels through every layer.
#pragma once

#include <string>

namespace rtb {

/// What a failure means to the person who ran the program. The values are the
/// exit statuses of the command line.
enum class ErrorKind {
  kFailure = 1,   ///< The work could not be done (disk full, child crashed).
  kBadInput = 2,  ///< An argument, a file or a scene is not acceptable.
  kMissing = 3,   ///< A device, a program or a compiled-in feature is absent.
};

/// An error that a user can cause and mend. Broken invariants of our own are
/// not Errors but RTB_CHECKs.
struct Error {
  ErrorKind kind = ErrorKind::kFailure;
  std::string place;  ///< `file:line:column`, an argument or a path.
  std::string what;   ///< What was found, and what was expected.
  std::string hint;   ///< How to mend it; may be empty.

  /// `place: what (hint)`, on one line, control characters made visible.
  std::string ToString() const;
};

/// @name Shorthands for the three kinds.
/// @{
Error Failure(std::string place, std::string what, std::string hint = "");
Error BadInput(std::string place, std::string what, std::string hint = "");
Error Missing(std::string place, std::string what, std::string hint = "");
/// @}

/// `text` with control characters (C0, DEL, C1) written as `\xNN`, so that no
/// escape sequence from a file ever reaches a terminal.
std::string Printable(const std::string& text);

}  // namespace rtb
