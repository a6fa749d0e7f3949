#include "harness/sweep/folder.h"

#include <algorithm>
#include <system_error>
#include <utility>

#include "core/base/file.h"
#include "harness/results/run_record_json.h"

namespace rtb {
namespace {

namespace fs = std::filesystem;

constexpr char kUnits[] = "units";
constexpr char kPictures[] = "pictures";
constexpr char kSuperseded[] = "superseded";
constexpr char kSuite[] = "suite.yaml";

Status MakeFolder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (!error) return {};
  return Fail(Failure(folder.string(), "cannot be made: " + error.message(),
                      "choose a place that you may write to"));
}

/// Success when a sweep may begin in a folder.
Status CheckUsable(const fs::path& folder, bool resume) {
  std::error_code ignored;
  if (!fs::exists(folder, ignored) || fs::is_empty(folder, ignored)) return {};
  if (!fs::is_directory(folder, ignored)) {
    return Fail(BadInput(
        "--out", "names " + folder.string() + ", which is not a folder"));
  }
  const bool a_sweep = fs::exists(folder / kSuite, ignored) ||
                       fs::exists(folder / kUnits, ignored);
  if (resume && a_sweep) return {};
  const std::string what = "names " + folder.string() + ", which holds ";
  if (a_sweep) {
    return Fail(BadInput("--out", what + "a sweep already",
                         "--resume runs what is missing in it; or name a new "
                         "folder"));
  }
  return Fail(BadInput("--out", what + "other files, expected an empty folder",
                       "name a new folder"));
}

/// The state that a record of ours tells of.
UnitState StateIn(const RunRecord& record) {
  if (!record.failure) {
    return record.runs.empty() ? UnitState::kMissing : UnitState::kDone;
  }
  if (record.failure->kind != "skipped") return UnitState::kFailed;
  // What is skipped can only be told by trying, but a block whose others have
  // run is done: its hash would change with what is missing.
  return record.runs.empty() ? UnitState::kSkipped : UnitState::kDone;
}

}  // namespace

Result<SweepFolder> SweepFolder::Open(const fs::path& folder,
                                      const std::string& suite, bool resume) {
  RTB_RETURN_IF_ERROR(CheckUsable(folder, resume));
  SweepFolder result(folder);
  // Whoever comes next sees a sweep from the first moment on.
  RTB_RETURN_IF_ERROR(MakeFolder(folder / kUnits));
  RTB_RETURN_IF_ERROR(MakeFolder(folder / kPictures));
  RTB_RETURN_IF_ERROR(result.Lock());
  const auto known = ReadFile(folder / kSuite);
  if (!known || *known != suite) {
    RTB_RETURN_IF_ERROR(WriteFileAtomically(folder / kSuite, suite));
  }
  result.Scan();
  return result;
}

SweepFolder SweepFolder::Look(const fs::path& folder) {
  SweepFolder result(folder);
  result.Scan();
  return result;
}

void SweepFolder::Scan() {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder_ / kUnits, error)) {
    const fs::path& file = entry.path();
    if (file.extension() != ".json") continue;
    found_[file.stem().string()] = ReadUnit(file);
  }
}

SweepFolder::Found SweepFolder::ReadUnit(const fs::path& file) const {
  const auto text = ReadFile(file);
  if (!text) return {};
  const auto record = ParseRecord(*text, file.string());
  if (!record || !record->unit) return {};
  const Unit& unit = *record->unit;
  const auto kind = FindUnitKind(unit.kind);
  if (!kind || file.stem() != unit.kind + "-" + unit.hash) return {};
  Found found{StateIn(*record), ConfigurationKey(*kind, unit.configuration)};
  const bool whole = std::ranges::all_of(
      record->runs, [this](const RunResult& run) { return HasPictures(run); });
  if (!whole) found.state = UnitState::kMissing;
  return found;
}

bool SweepFolder::HasPictures(const RunResult& run) const {
  const auto there = [this](const std::string& name) {
    if (name.empty()) return true;
    std::error_code error;
    const auto size = fs::file_size(folder_ / kPictures / name, error);
    return !error && size > 0;
  };
  return there(run.pictures.cells) && there(run.pictures.flip) &&
         there(run.pictures.reference);
}

UnitState SweepFolder::StateOf(const SweepUnit& unit) const {
  const auto found = found_.find(unit.Name());
  return found == found_.end() ? UnitState::kMissing : found->second.state;
}

Status SweepFolder::MoveAway(const std::string& name) {
  RTB_RETURN_IF_ERROR(MakeFolder(folder_ / kSuperseded));
  const std::string file = name + ".json";
  std::error_code error;
  fs::rename(folder_ / kUnits / file, folder_ / kSuperseded / file, error);
  found_.erase(name);
  // Another process may have moved it.
  if (!error || error == std::errc::no_such_file_or_directory) return {};
  return Fail(Failure((folder_ / kUnits / file).string(),
                      "cannot be moved: " + error.message()));
}

Result<int> SweepFolder::KeepOnly(const std::vector<SweepUnit>& units) {
  std::set<std::string> names;
  std::set<std::string> keys;
  for (const SweepUnit& unit : units) {
    names.insert(unit.Name());
    keys.insert(ConfigurationKey(unit.kind, unit.configuration));
  }
  std::vector<std::string> others;
  for (const auto& [name, found] : found_) {
    if (!names.contains(name) && !keys.contains(found.key)) {
      others.push_back(name);
    }
  }
  for (const std::string& name : others) RTB_RETURN_IF_ERROR(MoveAway(name));
  return static_cast<int>(others.size());
}

Status SweepFolder::Supersede(const SweepUnit& unit) {
  const std::string key = ConfigurationKey(unit.kind, unit.configuration);
  std::vector<std::string> others;
  for (const auto& [name, found] : found_) {
    if (found.key == key && name != unit.Name()) others.push_back(name);
  }
  for (const std::string& name : others) RTB_RETURN_IF_ERROR(MoveAway(name));
  return {};
}

Status SweepFolder::Write(const SweepUnit& unit, const RunRecord& record,
                          const std::vector<UnitFile>& files) {
  for (const UnitFile& file : files) {
    RTB_RETURN_IF_ERROR(
        WriteFileAtomically(folder_ / kPictures / file.name, file.bytes));
  }
  RTB_RETURN_IF_ERROR(WriteFileAtomically(
      folder_ / kUnits / (unit.Name() + ".json"), FormatRecord(record)));
  return Supersede(unit);
}

}  // namespace rtb
