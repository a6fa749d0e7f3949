#include "tests/bench/encode_timer.h"

#include <benchmark/benchmark.h>
#include <time.h>

#include <algorithm>

#include "core/base/check.h"
#include "tests/bench/bench.h"

namespace rtb {
namespace {

constexpr double kCellAspect = 0.5;

}  // namespace

double ThreadSeconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) +
         1e-9 * static_cast<double>(now.tv_nsec);
}

double Samples::Median() const {
  std::vector<double> sorted = seconds_;
  const auto middle =
      sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  return *middle;
}

double Samples::Least() const { return *std::ranges::min_element(seconds_); }

struct RecordedSource::Recording {
  BenchScene scene;
  std::vector<Fragments> answers;
};

Result<std::unique_ptr<RecordedSource>> RecordedSource::Make() {
  RTB_ASSIGN_OR_RETURN(BenchScene scene, LoadBenchScene("cornell"));
  std::unique_ptr<RecordedSource> source(new RecordedSource);
  source->recording_ = std::make_shared<Recording>();
  source->recording_->scene = std::move(scene);
  return source;
}

void RecordedSource::Rewind() {
  next_ = 0;
  spent_ = 0;
}

Result<Fragments> RecordedSource::Query(const SamplePlan& plan) {
  const double start = ThreadSeconds();
  auto fragments = Answer(plan);
  spent_ += ThreadSeconds() - start;
  return fragments;
}

Result<Fragments> RecordedSource::Answer(const SamplePlan& plan) {
  std::vector<Fragments>& answers = recording_->answers;
  if (next_ == answers.size()) {
    RTB_ASSIGN_OR_RETURN(Fragments fragments,
                         recording_->scene.backend->Render(plan, {}));
    answers.push_back(std::move(fragments));
  }
  // The copy brings the samples into the cache.
  Fragments fragments = answers[next_++];
  RTB_CHECK_EQ(fragments.samples_per_cell, plan.samples_per_cell);
  return fragments;
}

Result<std::unique_ptr<EncodeTimer>> EncodeTimer::Make(const Encoder& encoder) {
  RTB_ASSIGN_OR_RETURN(auto source, RecordedSource::Make());
  std::unique_ptr<EncodeTimer> timer(
      new EncodeTimer(encoder, std::move(source)));
  // The first run renders.
  RTB_RETURN_IF_ERROR(timer->Run(false));
  return timer;
}

Result<double> EncodeTimer::Run(bool scalar) {
  EncodeContext context;
  context.threads = 1;
  context.scalar = scalar;
  source_->Rewind();
  const double start = ThreadSeconds();
  RTB_ASSIGN_OR_RETURN(
      const Encoding encoding,
      encoder_.Run(*source_, kBenchGrid, kCellAspect, context));
  const double took = ThreadSeconds() - start;
  benchmark::DoNotOptimize(encoding.grid.cells.data());
  return took - source_->spent_seconds();
}

}  // namespace rtb
