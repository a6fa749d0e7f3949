/// @file
/// DrainedPty: a pseudo terminal without a person, for measuring.
#pragma once

#include <memory>
#include <thread>

#include "core/base/posix.h"
#include "core/base/result.h"
#include "core/render/sample_plan.h"

namespace rtb {

/// A thread reads everything that is written to the terminal and answers the
/// fence (DSR 5) as a terminal that draws in no time.
class DrainedPty {
 public:
  static Result<std::unique_ptr<DrainedPty>> Open(GridSize size);
  ~DrainedPty();
  DrainedPty(const DrainedPty&) = delete;
  DrainedPty& operator=(const DrainedPty&) = delete;

  /// The terminal as a program sees it: raw, non-blocking.
  int fd() const { return terminal_.get(); }

 private:
  DrainedPty() = default;
  void Drain();

  UniqueFd master_;
  UniqueFd terminal_;
  std::thread thread_;
};

}  // namespace rtb
