#include "core/scene/yaml_reader.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/suggest.h"
#include "core/scene/yaml_scalars.h"

namespace rtb {
namespace {

/// More visits than nodes can stand in a file come from aliases alone.
constexpr std::size_t kMaxVisits = kMaxYamlNodes;

std::string Quoted(std::string_view key) {
  return "`" + std::string(key) + "`";
}

std::string LengthWords(std::size_t low, std::size_t high) {
  if (low == high) return std::to_string(low);
  if (high == kNoLimit) return "at least " + std::to_string(low);
  return std::to_string(low) + ".." + std::to_string(high);
}

}  // namespace

void ReadContext::Fail(SourceMark mark, std::string what, std::string hint) {
  Fail(BadInput(PlaceOf(file_, mark), std::move(what), std::move(hint)));
}

void ReadContext::Fail(Error error) {
  if (ok()) error_ = std::move(error);
}

void ReadContext::CountVisit(SourceMark mark) {
  if (++visits_ <= kMaxVisits) return;
  Fail(mark,
       "more than " + std::to_string(kMaxVisits) +
           " values after aliases are followed",
       "use instances in place of aliases");
}

std::vector<YamlNode> ItemsOf(YamlNode list, std::string_view label,
                              std::size_t low, std::size_t high,
                              ReadContext& context) {
  std::vector<YamlNode> items;
  if (!list.is_list()) {
    FailExpected(list, label, "a list", context);
    return items;
  }
  if (list.HasChildren()) items.push_back(list.FirstChild());
  while (!items.empty() && items.back().HasNext()) {
    items.push_back(items.back().Next());
    context.CountVisit(items.back().mark());
    if (!context.ok()) return {};
  }
  if (items.size() < low || items.size() > high) {
    context.Fail(list.mark(), Quoted(label) + " has " +
                                  std::to_string(items.size()) +
                                  " items, expected " + LengthWords(low, high));
    items.clear();
  }
  return items;
}

MapReader::MapReader(YamlNode node, std::string owner, ReadContext& context)
    : node_(node), owner_(std::move(owner)), context_(context) {
  if (!context_.ok()) return;
  if (!node.is_map()) {
    context_.Fail(node.mark(), "found " + node.Describe() +
                                   ", expected a map with the "
                                   "keys of " +
                                   owner_);
    return;
  }
  ReadEntries();
  CheckDuplicates();
}

void MapReader::ReadEntries() {
  if (!node_.HasChildren()) return;
  for (YamlNode key = node_.FirstChild();; key = key.Next().Next()) {
    context_.CountVisit(key.mark());
    if (!key.is_scalar()) {
      context_.Fail(key.mark(), "a key of " + owner_ + " is " + key.Describe() +
                                    ", expected a word");
    }
    if (!ok()) return;
    const YamlNode value = key.Next();
    entries_.push_back({key.text(), key.mark(), value});
    if (!value.HasNext()) return;
  }
}

void MapReader::CheckDuplicates() const {
  std::vector<const Entry*> sorted;
  for (const Entry& entry : entries_) sorted.push_back(&entry);
  const auto by_key = [](const Entry* a, const Entry* b) {
    return a->key < b->key;
  };
  std::stable_sort(sorted.begin(), sorted.end(), by_key);
  const auto same = std::adjacent_find(
      sorted.begin(), sorted.end(),
      [](const Entry* a, const Entry* b) { return a->key == b->key; });
  if (same == sorted.end()) return;
  context_.Fail(
      (*(same + 1))->key_mark,
      "the key " + Quoted((*same)->key) + " stands twice in " + owner_ +
          ", expected once",
      "the first one is on line " + std::to_string((*same)->key_mark.line));
}

SourceMark MapReader::MarkOf(std::string_view key) const {
  for (const Entry& entry : entries_) {
    if (entry.key == key) return entry.value.mark();
  }
  return mark();
}

bool MapReader::Has(std::string_view key) { return Find(key).has_value(); }

std::optional<YamlNode> MapReader::Find(std::string_view key) {
  if (std::find(asked_.begin(), asked_.end(), key) == asked_.end()) {
    asked_.emplace_back(key);
  }
  if (!ok()) return {};
  for (Entry& entry : entries_) {
    if (entry.key != key) continue;
    entry.used = true;
    return entry.value;
  }
  return {};
}

std::optional<YamlNode> MapReader::Require(std::string_view key) {
  auto value = Find(key);
  if (!value && !missing_) missing_ = std::string(key);
  return value;
}

std::optional<MapReader> MapReader::FindMap(std::string_view key,
                                            std::string owner) {
  const auto value = Find(key);
  if (!value) return {};
  return MapReader(*value, std::move(owner), context_);
}

double MapReader::Number(std::string_view key, const Range& range,
                         std::optional<double> fallback) {
  const auto value = fallback ? Find(key) : Require(key);
  if (!value) return fallback.value_or(1);
  return ToNumber(*value, key, range, context_);
}

int MapReader::Integer(std::string_view key, int low, int high,
                       std::optional<int> fallback) {
  const auto value = fallback ? Find(key) : Require(key);
  if (!value) return fallback.value_or(low);
  return ToInteger(*value, key, low, high, context_);
}

bool MapReader::Bool(std::string_view key, bool fallback) {
  const auto value = Find(key);
  return value ? ToBool(*value, key, context_) : fallback;
}

V2d MapReader::Pair(std::string_view key, V2d fallback) {
  const auto value = Find(key);
  if (!value) return fallback;
  const auto items = ItemsOf(*value, key, 2, 2, context_);
  if (items.size() != 2) return fallback;
  return {ToNumber(items[0], key, kAnyNumber, context_),
          ToNumber(items[1], key, kAnyNumber, context_)};
}

V3d MapReader::Vector(std::string_view key, std::optional<V3d> fallback) {
  const auto value = fallback ? Find(key) : Require(key);
  if (!value) return fallback.value_or(V3d(0, 0, 0));
  return ToVector(*value, key, kAnyNumber, context_);
}

V3d MapReader::Direction(std::string_view key, std::optional<V3d> fallback) {
  const V3d v = Vector(key, fallback);
  const double largest =
      std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  if (ok() && !missing_ && largest < kSmallestPositive) {
    context_.Fail(MarkOf(key), Quoted(key) +
                                   " is a zero vector, expected one that "
                                   "points somewhere");
  }
  return v;
}

Rgb MapReader::Color(std::string_view key, const Range& range,
                     std::optional<Rgb> fallback) {
  const auto value = fallback ? Find(key) : Require(key);
  if (!value) return fallback.value_or(Rgb(0, 0, 0));
  return Rgb(ToVector(*value, key, range, context_));
}

std::vector<V3d> MapReader::Vectors(std::string_view key, std::size_t low,
                                    std::size_t high) {
  std::vector<V3d> vectors(low, V3d(0, 0, 0));
  const auto value = Require(key);
  if (!value) return vectors;
  const auto items = ItemsOf(*value, key, low, high, context_);
  if (!ok()) return vectors;
  vectors.clear();
  for (const YamlNode& item : items) {
    vectors.push_back(ToVector(item, key, kAnyNumber, context_));
  }
  return vectors;
}

std::vector<double> MapReader::Numbers(std::string_view key,
                                       const Range& range) {
  std::vector<double> numbers;
  const auto value = Require(key);
  if (!value) return numbers;
  for (const YamlNode& item : ItemsOf(*value, key, 1, kNoLimit, context_)) {
    numbers.push_back(ToNumber(item, key, range, context_));
  }
  return numbers;
}

std::string MapReader::Text(std::string_view key,
                            std::optional<std::string> fallback) {
  const auto value = fallback ? Find(key) : Require(key);
  return value ? ToText(*value, key, context_) : fallback.value_or("");
}

std::string MapReader::Name(std::string_view key,
                            std::optional<std::string> fallback) {
  const auto value = fallback ? Find(key) : Require(key);
  return value ? ToName(*value, key, context_) : fallback.value_or("");
}

std::size_t MapReader::Choice(std::string_view key,
                              std::span<const std::string> words,
                              std::optional<std::size_t> fallback) {
  const auto value = fallback ? Find(key) : Require(key);
  if (!value) return fallback.value_or(0);
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (value->is_scalar() && value->text() == words[i]) return i;
  }
  FailExpected(
      *value, key, "one of " + JoinNames(words), context_,
      value->is_scalar() ? DidYouMean(value->text(), words) : std::string());
  return 0;
}

std::size_t MapReader::Type(std::span<const std::string> words) {
  const std::size_t type = Choice("type", words);
  if (missing_) FailMissing();
  return type;
}

void MapReader::FailMissing() const {
  std::string hint;
  for (const Entry& entry : entries_) {
    const std::string wanted[] = {*missing_};
    if (entry.used || DidYouMean(entry.key, wanted).empty()) continue;
    hint = "the key `" + std::string(entry.key) + "` on line " +
           std::to_string(entry.key_mark.line) + " looks like it";
  }
  context_.Fail(mark(), owner_ + " lacks the required key " + Quoted(*missing_),
                std::move(hint));
}

void MapReader::Finish() {
  for (const Entry& entry : entries_) {
    if (entry.used || !ok()) continue;
    const std::string near = DidYouMean(entry.key, asked_);
    context_.Fail(entry.key_mark,
                  "unknown key `" + std::string(entry.key.substr(0, 64)) +
                      "` in " + owner_,
                  near.empty() ? "its keys are " + JoinNames(asked_) : near);
  }
  if (missing_) FailMissing();
}

}  // namespace rtb
