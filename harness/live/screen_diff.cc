#include "harness/live/screen_diff.h"

#include <algorithm>
#include <numeric>

namespace rtb {
namespace {

int CountDiffering(const CellGrid& a, const CellGrid& b) {
  if (a.size != b.size) return b.size.cells();
  int count = 0;
  for (std::size_t i = 0; i < a.cells.size(); ++i) {
    count += Canonical(a.cells[i]) == Canonical(b.cells[i]) ? 0 : 1;
  }
  return count;
}

}  // namespace

std::vector<int> ScreenDiff::Select(const CellGrid& wanted,
                                    const DiffLimits& limits) {
  cleared_ = !known_ || wanted.size != shown_.size;
  differing_ = CountDiffering(wanted_, wanted);
  wanted_ = wanted;
  if (cleared_) return SendAll(wanted);
  std::vector<Candidate> candidates = Candidates(wanted, limits);
  const auto budget = static_cast<std::size_t>(std::max(limits.budget, 1));
  if (candidates.size() > budget) {
    std::nth_element(candidates.begin(),
                     candidates.begin() + static_cast<std::ptrdiff_t>(budget),
                     candidates.end(),
                     [](const Candidate& a, const Candidate& b) {
                       return a.priority != b.priority ? a.priority > b.priority
                                                       : a.index < b.index;
                     });
    candidates.resize(budget);
  }
  std::vector<int> sent;
  sent.reserve(candidates.size());
  for (const Candidate& candidate : candidates) {
    const auto at = static_cast<std::size_t>(candidate.index);
    shown_.cells[at] = wanted.cells[at];
    ages_[at] = 0;
    sent.push_back(candidate.index);
  }
  waiting_ -= static_cast<int>(sent.size());
  std::sort(sent.begin(), sent.end());
  return sent;
}

std::vector<int> ScreenDiff::SendAll(const CellGrid& wanted) {
  shown_ = wanted;
  ages_.assign(wanted.cells.size(), 0);
  known_ = true;
  waiting_ = 0;
  std::vector<int> all(wanted.cells.size());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

std::vector<ScreenDiff::Candidate> ScreenDiff::Candidates(
    const CellGrid& wanted, const DiffLimits& limits) {
  std::vector<Candidate> candidates;
  waiting_ = 0;
  for (std::size_t i = 0; i < wanted.cells.size(); ++i) {
    if (wanted.cells[i] == shown_.cells[i]) {
      ages_[i] = 0;
      continue;
    }
    const float difference =
        table_.Difference(shown_.cells[i], wanted.cells[i]);
    if (difference == 0) {
      ages_[i] = 0;
      continue;
    }
    ++waiting_;
    ++ages_[i];
    if (difference <= limits.threshold && ages_[i] < limits.oldest) continue;
    // What has waited long counts more, so that nothing waits for ever.
    candidates.push_back(
        {difference * static_cast<float>(ages_[i]), static_cast<int>(i)});
  }
  return candidates;
}

}  // namespace rtb
