#include "harness/run_encoder.h"

#include <chrono>
#include <ctime>

#include "harness/arguments.h"

namespace rtb {
namespace {

using Clock = std::chrono::steady_clock;

double Milliseconds(Clock::duration duration) {
  return std::chrono::duration<double, std::milli>(duration).count();
}

/// CPU time of the process so far, in milliseconds.
double CpuMilliseconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) * 1e3 +
         static_cast<double>(now.tv_nsec) * 1e-6;
}

/// Passes queries on and adds up the time that they take.
class TimedSource : public FragmentSource {
 public:
  explicit TimedSource(FragmentSource& source) : source_(source) {}

  Result<Fragments> Query(const SamplePlan& plan) override {
    const auto start = Clock::now();
    auto fragments = source_.Query(plan);
    total_ += Clock::now() - start;
    return fragments;
  }

  Clock::duration total() const { return total_; }

 private:
  FragmentSource& source_;
  Clock::duration total_{};
};

}  // namespace

Result<TimedEncoding> RunEncoder(const Encoder& encoder, FragmentSource& source,
                                 GridSize grid, double cell_aspect,
                                 const EncodeContext& context) {
  // Before a plan of the whole grid is made.
  const SamplePlan one = encoder.Plan({1, 1}, cell_aspect, context.seed);
  RTB_RETURN_IF_ERROR(CheckSampleCount("--grid", grid, one.samples_per_cell));
  TimedSource timed_source(source);
  TimedEncoding timed;
  const double cpu_start = CpuMilliseconds();
  const auto start = Clock::now();
  RTB_ASSIGN_OR_RETURN(timed.encoding,
                       encoder.Run(timed_source, grid, cell_aspect, context));
  const auto total = Clock::now() - start;
  timed.cpu_ms = CpuMilliseconds() - cpu_start;
  timed.render_ms = Milliseconds(timed_source.total());
  timed.encode_ms = Milliseconds(total - timed_source.total());
  return timed;
}

}  // namespace rtb
