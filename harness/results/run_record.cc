#include "harness/results/run_record.h"

#include <algorithm>

#include "harness/results/statistics.h"

namespace rtb {

const StageTimes* FindStage(const RunResult& run, const std::string& stage) {
  const auto found = std::ranges::find(run.times, stage, &StageTimes::stage);
  return found == run.times.end() ? nullptr : &*found;
}

std::optional<double> FindMetricValue(const RunResult& run,
                                      const std::string& metric) {
  const auto found = std::ranges::find(run.metrics, metric, &MetricValue::name);
  return found == run.metrics.end() ? std::nullopt : found->value;
}

std::optional<double> FramesPerSecond(const RunResult& run) {
  const StageTimes* render = FindStage(run, "render");
  const StageTimes* encode = FindStage(run, "encode");
  if (render == nullptr || encode == nullptr) return std::nullopt;
  const double ms = Median(render->samples) + Median(encode->samples);
  if (!(ms > 0)) return std::nullopt;
  return 1000 / ms;
}

}  // namespace rtb
