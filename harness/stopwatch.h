/// @file
/// Stopwatch: wall and CPU time of a piece of work.
#pragma once

#include <chrono>

#include "harness/results/run_record.h"

namespace rtb {

/// What a piece of work took, in milliseconds.
struct Cost {
  double wall_ms = 0;
  double cpu_ms = 0;  ///< Of all threads of the process.
};

Cost operator+(const Cost& a, const Cost& b);
Cost operator-(const Cost& a, const Cost& b);

/// Runs from its construction on.
class Stopwatch {
 public:
  Stopwatch();
  Cost Read() const;

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point wall_start_;
  double cpu_start_;
};

/// Appends one run.
void AddTime(const Cost& cost, StageTimes& times);

}  // namespace rtb
