#include "harness/live/pair_pool.h"

namespace rtb {

PairPool::PairPool(int pairs)
    : colors_(static_cast<std::size_t>(pairs) + 1),
      uses_(static_cast<std::size_t>(pairs) + 1, 0) {
  for (int pair = pairs; pair > 0; --pair) free_.push_back(pair);
}

std::optional<PairPool::Lease> PairPool::Acquire(const PairColors& colors) {
  const auto found = pairs_.find(colors);
  if (found != pairs_.end()) {
    ++uses_[static_cast<std::size_t>(found->second)];
    return Lease{found->second, false};
  }
  if (free_.empty()) return std::nullopt;
  const int pair = free_.back();
  free_.pop_back();
  pairs_.emplace(colors, pair);
  colors_[static_cast<std::size_t>(pair)] = colors;
  uses_[static_cast<std::size_t>(pair)] = 1;
  return Lease{pair, true};
}

int PairPool::Substitute(const PairColors& colors) const {
  int any = 0;
  for (const auto& [used, pair] : pairs_) {
    if (used.bg == colors.bg) return pair;
    any = pair;
  }
  return any;
}

void PairPool::Settle() {
  for (const int pair : released_) {
    const auto at = static_cast<std::size_t>(pair);
    if (pair == 0 || --uses_[at] > 0) continue;
    pairs_.erase(colors_[at]);
    free_.push_back(pair);
  }
  released_.clear();
}

}  // namespace rtb
