#include <sstream>

#include "harness/metrics/metric.h"

namespace rtb {

#define RTB_METRIC(name) Metric name##Metric();
#include "harness/metrics/metrics.inc"
#undef RTB_METRIC

namespace {

std::string SizeText(const Image& image) {
  std::ostringstream out;
  out << image.width() << "x" << image.height();
  return out.str();
}

}  // namespace

MetricInput::MetricInput(const Image& reference, const Image& test, int threads)
    : reference_(reference), test_(test), threads_(threads) {
  RTB_CHECK_EQ(reference.width(), test.width());
  RTB_CHECK_EQ(reference.height(), test.height());
  RTB_CHECK(!reference.empty());
}

std::span<const Metric> Metrics() {
#define RTB_METRIC(name) name##Metric(),
  static const Metric kMetrics[] = {
#include "harness/metrics/metrics.inc"
  };
#undef RTB_METRIC
  return kMetrics;
}

const Metric* FindMetric(const std::string& name) {
  for (const Metric& metric : Metrics()) {
    if (name == metric.name) return &metric;
  }
  return nullptr;
}

std::vector<MetricValue> ComputeMetrics(const MetricInput& input) {
  std::vector<MetricValue> values;
  for (const Metric& metric : Metrics()) {
    values.push_back({metric.name, metric.compute(input)});
  }
  return values;
}

Result<std::vector<MetricValue>> Score(const Image& reference,
                                       const Image& test, int threads) {
  if (reference.width() != test.width() ||
      reference.height() != test.height()) {
    return Fail(BadInput("image",
                         "has " + SizeText(test) +
                             " pixels where the reference has " +
                             SizeText(reference),
                         "bring both to one size first"));
  }
  if (reference.empty()) {
    return Fail(BadInput("image", "has no pixels"));
  }
  return ComputeMetrics(MetricInput(reference, test, threads));
}

}  // namespace rtb
