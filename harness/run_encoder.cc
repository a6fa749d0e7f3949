#include "harness/run_encoder.h"

#include <algorithm>
#include <chrono>
#include <optional>

#include "harness/cpu_time.h"

namespace rtb {
namespace {

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

Cost operator+(const Cost& a, const Cost& b) {
  return {a.wall_ms + b.wall_ms, a.cpu_ms + b.cpu_ms};
}

Cost operator-(const Cost& a, const Cost& b) {
  return {a.wall_ms - b.wall_ms, a.cpu_ms - b.cpu_ms};
}

/// Passes queries on and adds up what they take. Its clock starts with it.
class TimedSource : public FragmentSource {
 public:
  explicit TimedSource(FragmentSource& source) : source_(source) {}

  Result<Fragments> Query(const SamplePlan& plan) override {
    const Cost begin = stopwatch_.Read();
    if (!first_query_) first_query_ = begin;
    auto fragments = source_.Query(plan);
    inside_ = inside_ + (stopwatch_.Read() - begin);
    return fragments;
  }

  /// Writes what it took up to now.
  void Report(TimedEncoding& timed) const {
    const Cost total = stopwatch_.Read();
    timed.plan = first_query_.value_or(Cost{});
    timed.render = inside_;
    timed.encode = total - timed.plan - timed.render;
    // Rounding alone can take it below 0.
    timed.encode.cpu_ms = std::max(timed.encode.cpu_ms, 0.0);
    timed.encode.wall_ms = std::max(timed.encode.wall_ms, 0.0);
  }

 private:
  FragmentSource& source_;
  Cost inside_;
  std::optional<Cost> first_query_;
  Stopwatch stopwatch_;
};

}  // namespace

Result<TimedEncoding> RunEncoder(const Encoder& encoder, FragmentSource& source,
                                 GridSize grid, double cell_aspect,
                                 const EncodeContext& context) {
  TimedEncoding timed;
  TimedSource timed_source(source);
  RTB_ASSIGN_OR_RETURN(timed.encoding,
                       encoder.Run(timed_source, grid, cell_aspect, context));
  timed_source.Report(timed);
  return timed;
}

}  // namespace rtb
