#include "encoders/evidence.h"

#include <numeric>

namespace rtb {
namespace {

/// Samples of each cell over all rounds.
std::vector<std::size_t> Count(const Evidence& evidence) {
  std::vector<std::size_t> counts;
  for (const SampleRound& round : evidence.rounds) {
    counts.resize(static_cast<std::size_t>(round.plan.grid.cells()));
    for (int entry = 0; entry < round.plan.entries(); ++entry) {
      counts[static_cast<std::size_t>(round.plan.cell(entry))] +=
          static_cast<std::size_t>(round.plan.samples_per_cell);
    }
  }
  return counts;
}

}  // namespace

SamplesByCell::SamplesByCell(const Evidence& evidence) {
  const std::vector<std::size_t> counts = Count(evidence);
  begin_.resize(counts.size() + 1);
  std::inclusive_scan(counts.begin(), counts.end(), begin_.begin() + 1);
  samples_.resize(begin_.back());
  std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
  for (const SampleRound& round : evidence.rounds) {
    std::size_t value = 0;
    for (int entry = 0; entry < round.plan.entries(); ++entry) {
      std::size_t& at = next[static_cast<std::size_t>(round.plan.cell(entry))];
      for (int i = 0; i < round.plan.samples_per_cell; ++i, ++value) {
        const std::vector<float>& variances = round.fragments.variances;
        samples_[at++] = {round.plan.position(entry, i), round.plan.footprint,
                          round.fragments.values[value],
                          variances.empty() ? 0.0f : variances[value]};
      }
    }
  }
}

}  // namespace rtb
