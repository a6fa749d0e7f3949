/// @file
/// SweepFolder: where a sweep keeps its units and their pictures.
///
///     suite.yaml                     the suite
///     units/KIND-HASH.json           one record a unit
///     pictures/KIND-HASH.N.*         what run N of it drew
///     pictures/reference-HASH.jpg    references as displayed
///     superseded/                    records of older inputs
///
/// Every file is written under a temporary name and renamed, a unit's pictures
/// before its record: a record that is there is whole. Several processes may
/// work in one folder.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "core/base/posix.h"
#include "core/base/result.h"
#include "harness/results/run_record.h"
#include "harness/sweep/unit.h"

namespace rtb {

/// What is known of a unit's record.
enum class UnitState {
  kMissing,  ///< There is none, or what is there is damaged.
  kDone,
  kFailed,   ///< Tried, and to be tried again.
  kSkipped,  ///< A program, a library or a device was missing.
};

/// One file to be written beside a record.
struct UnitFile {
  std::string name;  ///< In the folder of pictures.
  std::string bytes;
};

class SweepFolder {
 public:
  /// Takes a folder, making it where it is not there. Leftovers of processes
  /// that were killed are removed, unless another process is at work here.
  /// @param suite the suite's text, which is kept.
  /// @param resume whether the folder may hold something already.
  /// @return kBadInput for a folder that holds something else.
  static Result<SweepFolder> Open(const std::filesystem::path& folder,
                                  const std::string& suite, bool resume);

  /// Looks at a folder without changing it.
  static SweepFolder Look(const std::filesystem::path& folder);

  UnitState StateOf(const SweepUnit& unit) const;

  /// Moves records of configurations that are none of these units' away.
  /// @return how many there were.
  Result<int> KeepOnly(const std::vector<SweepUnit>& units);

  /// Moves records of the unit's configuration with another hash away.
  Status Supersede(const SweepUnit& unit);

  /// Writes the files, then the record, and supersedes.
  Status Write(const SweepUnit& unit, const RunRecord& record,
               const std::vector<UnitFile>& files);

 private:
  /// A record that was found.
  struct Found {
    UnitState state = UnitState::kMissing;
    std::string key;  ///< Of its configuration; empty: damaged.
  };
  explicit SweepFolder(std::filesystem::path folder)
      : folder_(std::move(folder)) {}

  /// Reads all records.
  void Scan();
  Found ReadUnit(const std::filesystem::path& file) const;
  bool HasPictures(const RunResult& run) const;
  Status Lock();
  void RemoveLeftovers() const;
  Status MoveAway(const std::string& name);

  std::filesystem::path folder_;
  UniqueFd lock_;                       ///< Shared while we work.
  std::map<std::string, Found> found_;  ///< By name.
};

}  // namespace rtb
