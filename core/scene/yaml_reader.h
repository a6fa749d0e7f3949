/// @file
/// MapReader: typed access to the keys of a YAML map. It checks types and
/// ranges, and knows which keys the format has, so that a key which nobody
/// asked for is an error. Errors gather in a ReadContext, which keeps the
/// first: callers read on with neutral values and ask once at the end.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/math/vec.h"
#include "core/scene/range.h"
#include "core/scene/yaml_tree.h"

namespace rtb {

/// The first error of a scene file, and the budget of the reading.
class ReadContext {
 public:
  explicit ReadContext(const std::filesystem::path& file)
      : file_(file.string()) {}

  bool ok() const { return !error_.has_value(); }
  /// The first error; only when !ok().
  const Error& error() const { return *error_; }
  const std::string& file() const { return file_; }

  /// Notes an error, unless there is one already.
  void Fail(SourceMark mark, std::string what, std::string hint = "");
  void Fail(Error error);
  /// Counts a visited node, which bounds what aliases of aliases can cost.
  void CountVisit(SourceMark mark);

 private:
  std::string file_;
  std::optional<Error> error_;
  std::size_t visits_ = 0;
};

/// Longest list that can be asked for.
inline constexpr std::size_t kNoLimit = kMaxYamlNodes;

/// The keys of one map. Values of keys are read by name; a key without a
/// fallback is required. After an error the returned values mean nothing.
class MapReader {
 public:
  /// @param owner what the map describes, with its article: "a sphere".
  MapReader(YamlNode node, std::string owner, ReadContext& context);

  bool ok() const { return context_.ok(); }
  /// Whether every value read so far was there and acceptable.
  bool complete() const { return ok() && !missing_; }
  ReadContext& context() const { return context_; }
  SourceMark mark() const { return node_.mark(); }
  /// The place of a key's value, or the map's own.
  SourceMark MarkOf(std::string_view key) const;
  /// Changes what messages call the map ("an object" turns into "a sphere").
  void set_owner(std::string owner) { owner_ = std::move(owner); }

  bool Has(std::string_view key);
  /// The value of a key; nothing when it is absent.
  std::optional<YamlNode> Find(std::string_view key);
  /// The same for a required key, whose absence Finish reports.
  std::optional<YamlNode> Require(std::string_view key);
  /// The reader of a map-valued key that is present.
  std::optional<MapReader> FindMap(std::string_view key, std::string owner);

  double Number(std::string_view key, const Range& range,
                std::optional<double> fallback = {});
  int Integer(std::string_view key, int low, int high,
              std::optional<int> fallback = {});
  bool Bool(std::string_view key, bool fallback);
  V2d Pair(std::string_view key, V2d fallback);
  V3d Vector(std::string_view key, std::optional<V3d> fallback = {});
  /// A vector that is not zero.
  V3d Direction(std::string_view key, std::optional<V3d> fallback = {});
  Rgb Color(std::string_view key, const Range& range,
            std::optional<Rgb> fallback = {});
  /// A required list of `low` to `high` vectors.
  std::vector<V3d> Vectors(std::string_view key, std::size_t low,
                           std::size_t high = kNoLimit);
  /// A required list of at least one number.
  std::vector<double> Numbers(std::string_view key, const Range& range);
  /// One line of text without control characters.
  std::string Text(std::string_view key,
                   std::optional<std::string> fallback = {});
  /// [A-Za-z0-9_-]+.
  std::string Name(std::string_view key,
                   std::optional<std::string> fallback = {});
  /// One of `words`, as its position.
  std::size_t Choice(std::string_view key, std::span<const std::string> words,
                     std::optional<std::size_t> fallback = {});

  /// The required key `type`, one of `words`, as its position. Absence is an
  /// error at once: without the type the other keys mean nothing.
  std::size_t Type(std::span<const std::string> words);

  /// Reports the first key that nobody has asked for, then required keys that
  /// were absent. To be called when everything has been read.
  void Finish();

 private:
  struct Entry {
    std::string_view key;
    SourceMark key_mark;
    YamlNode value;
    bool used = false;
  };
  void ReadEntries();
  void CheckDuplicates() const;
  void FailMissing() const;

  YamlNode node_;
  std::string owner_;
  ReadContext& context_;
  std::vector<Entry> entries_;
  std::vector<std::string> asked_;
  std::optional<std::string> missing_;
};

/// The items of a list; an error and nothing when the node is no list or its
/// length is not within `low`..`high`.
std::vector<YamlNode> ItemsOf(YamlNode list, std::string_view label,
                              std::size_t low, std::size_t high,
                              ReadContext& context);

}  // namespace rtb
