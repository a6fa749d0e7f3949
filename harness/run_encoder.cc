#include "harness/run_encoder.h"

#include <chrono>
#include <ctime>

namespace rtb {
namespace {

/// CPU time of the process so far, in milliseconds.
double CpuMilliseconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) * 1e3 +
         static_cast<double>(now.tv_nsec) * 1e-6;
}

/// Runs from its construction on.
class Stopwatch {
 public:
  Cost Read() const {
    const auto wall = Clock::now() - wall_start_;
    return {std::chrono::duration<double, std::milli>(wall).count(),
            CpuMilliseconds() - cpu_start_};
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point wall_start_ = Clock::now();
  double cpu_start_ = CpuMilliseconds();
};

/// Passes queries on and adds up what they take.
class TimedSource : public FragmentSource {
 public:
  explicit TimedSource(FragmentSource& source) : source_(source) {}

  Result<Fragments> Query(const SamplePlan& plan) override {
    const Stopwatch stopwatch;
    auto fragments = source_.Query(plan);
    const Cost cost = stopwatch.Read();
    total_.wall_ms += cost.wall_ms;
    total_.cpu_ms += cost.cpu_ms;
    return fragments;
  }

  Cost total() const { return total_; }

 private:
  FragmentSource& source_;
  Cost total_;
};

}  // namespace

Result<TimedEncoding> RunEncoder(const Encoder& encoder, FragmentSource& source,
                                 GridSize grid, double cell_aspect,
                                 const EncodeContext& context) {
  TimedSource timed_source(source);
  TimedEncoding timed;
  const Stopwatch stopwatch;
  RTB_ASSIGN_OR_RETURN(timed.encoding,
                       encoder.Run(timed_source, grid, cell_aspect, context));
  const Cost total = stopwatch.Read();
  timed.render = timed_source.total();
  timed.encode = {total.wall_ms - timed.render.wall_ms,
                  total.cpu_ms - timed.render.cpu_ms};
  return timed;
}

}  // namespace rtb
