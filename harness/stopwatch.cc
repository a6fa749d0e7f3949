#include "harness/stopwatch.h"

#include "harness/cpu_time.h"

namespace rtb {

Cost operator+(const Cost& a, const Cost& b) {
  return {a.wall_ms + b.wall_ms, a.cpu_ms + b.cpu_ms};
}

Cost operator-(const Cost& a, const Cost& b) {
  return {a.wall_ms - b.wall_ms, a.cpu_ms - b.cpu_ms};
}

Stopwatch::Stopwatch()
    : wall_start_(Clock::now()), cpu_start_(CpuMilliseconds()) {}

Cost Stopwatch::Read() const {
  const auto wall = Clock::now() - wall_start_;
  return {std::chrono::duration<double, std::milli>(wall).count(),
          CpuMilliseconds() - cpu_start_};
}

void AddTime(const Cost& cost, StageTimes& times) {
  times.samples.push_back(cost.wall_ms);
  times.cpu_samples.push_back(cost.cpu_ms);
}

}  // namespace rtb
