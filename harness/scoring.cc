#include "harness/scoring.h"

#include "harness/metrics/metric.h"

namespace rtb {

nlohmann::ordered_json Score(const RasterPair& pair) {
  nlohmann::ordered_json scores = nlohmann::ordered_json::object();
  for (const Metric& metric : Metrics()) {
    const auto value = metric.compute({pair.reference, pair.test});
    scores[metric.name] = value ? nlohmann::ordered_json(*value)
                                : nlohmann::ordered_json(nullptr);
  }
  return scores;
}

}  // namespace rtb
