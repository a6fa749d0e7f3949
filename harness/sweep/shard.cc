#include "harness/sweep/shard.h"

#include <map>

#include "core/base/numbers.h"

namespace rtb {
namespace {

constexpr int kMostShards = 1'000'000;

/// The same for all units of a block.
std::string BlockKey(const SweepUnit& unit) {
  UnitConfiguration block = unit.configuration;
  block.encoders.clear();
  block.seed = 0;
  return ConfigurationKey(unit.kind, block);
}

}  // namespace

Result<Shard> ParseShard(const std::string& place, const std::string& text) {
  const std::size_t slash = text.find('/');
  const std::string_view view = text;
  if (slash != std::string::npos) {
    const auto index = ParseWhole<int>(view.substr(0, slash));
    const auto count = ParseWhole<int>(view.substr(slash + 1));
    if (index && count && *index >= 0 && *index < *count &&
        *count <= kMostShards) {
      return Shard{*index, *count};
    }
  }
  return Fail(NotExpected(place, text,
                          "I/N such as 0/4, with I from 0 to N - 1 and N at "
                          "most " +
                              std::to_string(kMostShards)));
}

std::vector<SweepUnit> SliceOf(const std::vector<SweepUnit>& units,
                               Shard shard) {
  std::map<std::string, int> blocks;  // Their numbers, as they first appear.
  std::vector<SweepUnit> slice;
  for (const SweepUnit& unit : units) {
    const int next = static_cast<int>(blocks.size());
    const int block = blocks.emplace(BlockKey(unit), next).first->second;
    if (block % shard.count == shard.index) slice.push_back(unit);
  }
  return slice;
}

}  // namespace rtb
