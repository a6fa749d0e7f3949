/// @file
/// Recorder: what a terminal was sent, as asciicast v2.
/// Source: docs.asciinema.org, "asciicast v2".
#pragma once

#include <string>
#include <string_view>

#include "core/base/posix.h"
#include "core/base/result.h"
#include "core/render/sample_plan.h"

namespace rtb {

/// One recording. Every line is written at once, so that what was recorded
/// outlives a crash.
class Recorder {
 public:
  /// Begins a file with its header.
  /// @param now seconds on the clock that events are given in.
  static Result<Recorder> Start(const std::string& file, GridSize size,
                                double now);

  /// Bytes that were sent; whole UTF-8 characters.
  Status Output(std::string_view bytes, double now);
  /// The terminal has another size.
  Status Resize(GridSize size, double now);

  const std::string& file() const { return file_; }

 private:
  Recorder() = default;
  Status Event(const char* kind, std::string_view data, double now);

  UniqueFd fd_;
  std::string file_;
  double start_ = 0;
};

}  // namespace rtb
