#include "harness/sweep/folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/file.h"
#include "tests/harness/temporary_folder.h"

namespace rtb {
namespace {

using ::testing::HasSubstr;
namespace fs = std::filesystem;

class SweepFolderTest : public ::testing::Test {
 protected:
  SweepFolderTest() {
    unit_.configuration.scene = "sky";
    unit_.configuration.grid = {12, 4};
    unit_.configuration.encoders = {"half"};
    unit_.hash = "0123456789abcdef";
  }

  Result<SweepFolder> Open(bool resume = true) {
    return SweepFolder::Open(path_, "the suite", resume);
  }

  /// The record of `unit_` with one run.
  RunRecord Record() const {
    RunRecord record;
    record.unit = {"quality", "test", unit_.hash, unit_.configuration};
    record.conditions.utc = "2026-01-31T12:34:56Z";
    RunResult run;
    run.scene = "sky";
    run.encoder = "half";
    run.grid = {12, 4};
    run.raster = run.reference_raster = {96, 64};
    run.pictures.cells = "quality-0123456789abcdef.0.cells.json.gz";
    record.runs.push_back(run);
    return record;
  }

  void Write(const RunRecord& record) {
    SweepFolder folder = Open().value();
    const std::vector<UnitFile> files = {
        {"quality-0123456789abcdef.0.cells.json.gz", "cells"}};
    ASSERT_TRUE(folder.Write(unit_, record, files));
  }

  UnitState State() { return SweepFolder::Look(path_).StateOf(unit_); }
  fs::path UnitFilePath() const {
    return path_ / "units" / (unit_.Name() + ".json");
  }

  TemporaryFolder folder_;
  fs::path path_ = folder_.path() / "sweep";
  SweepUnit unit_;
};

TEST_F(SweepFolderTest, KeepsTheSuiteAndWhatIsWritten) {
  EXPECT_EQ(State(), UnitState::kMissing);
  Write(Record());
  EXPECT_EQ(State(), UnitState::kDone);
  EXPECT_EQ(ReadFile(path_ / "suite.yaml"), "the suite");
  EXPECT_EQ(
      ReadFile(path_ / "pictures/quality-0123456789abcdef.0.cells.json.gz"),
      "cells");
}

TEST_F(SweepFolderTest, AFolderInUseIsTakenToResumeAlone) {
  ASSERT_TRUE(Open(false));
  const auto again = Open(false);
  ASSERT_FALSE(again);
  EXPECT_EQ(again.error().kind, ErrorKind::kBadInput);
  EXPECT_THAT(again.error().ToString(), HasSubstr("--resume runs what is"));
  EXPECT_TRUE(Open(true));
}

TEST_F(SweepFolderTest, AFolderOfOtherThingsIsNeverTaken) {
  folder_.Write("sweep/letter.txt", "Dear");
  for (const bool resume : {false, true}) {
    const auto opened = Open(resume);
    ASSERT_FALSE(opened);
    EXPECT_THAT(opened.error().what, HasSubstr("other files"));
  }
}

TEST_F(SweepFolderTest, DamagedRecordsCountAsMissing) {
  Write(Record());
  const std::string text = *ReadFile(UnitFilePath());
  for (const std::size_t size : {std::size_t{0}, text.size() / 2}) {
    folder_.Write("sweep/units/" + unit_.Name() + ".json",
                  text.substr(0, size));
    EXPECT_EQ(State(), UnitState::kMissing) << size;
  }
  folder_.Write("sweep/units/" + unit_.Name() + ".json", text);
  EXPECT_EQ(State(), UnitState::kDone);
  fs::remove(path_ / "pictures/quality-0123456789abcdef.0.cells.json.gz");
  EXPECT_EQ(State(), UnitState::kMissing);
}

TEST_F(SweepFolderTest, AnotherUnitsRecordIsNotTaken) {
  Write(Record());
  SweepUnit other = unit_;
  other.hash = "fedcba9876543210";
  fs::copy(UnitFilePath(), path_ / "units" / (other.Name() + ".json"));
  EXPECT_EQ(SweepFolder::Look(path_).StateOf(other), UnitState::kMissing);
}

TEST_F(SweepFolderTest, FailuresAreTriedAgainAndBlocksThatRanAreNot) {
  RunRecord record = Record();
  record.failure = {"failed", "half", "half", "broke", ""};
  Write(record);
  EXPECT_EQ(State(), UnitState::kFailed);
  record.failure->kind = "skipped";
  Write(record);
  EXPECT_EQ(State(), UnitState::kDone);
  record.runs.clear();
  Write(record);
  EXPECT_EQ(State(), UnitState::kSkipped);
}

TEST_F(SweepFolderTest, LeftoversOfTheKilledGo) {
  Write(Record());
  folder_.Write("sweep/units/.rtbench.1.0.tmp", "{\"sch");
  folder_.Write("sweep/pictures/.rtbench.1.1.tmp", "GIF");
  folder_.Write("sweep/pictures/timing-00.0.flip.jpg", "of no record");
  folder_.Write("sweep/pictures/reference-00.jpg", "of any");
  {
    const SweepFolder other = Open().value();
    EXPECT_FALSE(fs::exists(path_ / "units/.rtbench.1.0.tmp"));
    EXPECT_FALSE(fs::exists(path_ / "pictures/.rtbench.1.1.tmp"));
    EXPECT_FALSE(fs::exists(path_ / "pictures/timing-00.0.flip.jpg"));
    EXPECT_TRUE(fs::exists(path_ / "pictures/reference-00.jpg"));
    EXPECT_EQ(State(), UnitState::kDone);
    // Beside a process at work nothing is a leftover.
    folder_.Write("sweep/units/.rtbench.2.0.tmp", "{");
    ASSERT_TRUE(Open());
    EXPECT_TRUE(fs::exists(path_ / "units/.rtbench.2.0.tmp"));
  }
  ASSERT_TRUE(Open());
  EXPECT_FALSE(fs::exists(path_ / "units/.rtbench.2.0.tmp"));
}

TEST_F(SweepFolderTest, RecordsOfOlderInputsMakeRoom) {
  Write(Record());
  const std::string old_name = unit_.Name();
  unit_.hash = "fedcba9876543210";  // As after a change of the scene.
  EXPECT_EQ(Open()->KeepOnly({unit_}).value(), 0);
  EXPECT_TRUE(fs::exists(path_ / "units" / (old_name + ".json")));
  RunRecord record = Record();
  record.runs[0].pictures = {};
  Write(record);
  EXPECT_FALSE(fs::exists(path_ / "units" / (old_name + ".json")));
  EXPECT_TRUE(fs::exists(path_ / "superseded" / (old_name + ".json")));
  EXPECT_EQ(State(), UnitState::kDone);
}

TEST_F(SweepFolderTest, RecordsOfNoUnitAreMovedAway) {
  Write(Record());
  folder_.Write("sweep/units/quality-77.json", "damaged");
  SweepUnit other = unit_;
  other.configuration.scene = "sun";
  other.hash = "fedcba9876543210";
  EXPECT_EQ(Open()->KeepOnly({other}).value(), 2);
  EXPECT_EQ(State(), UnitState::kMissing);
  EXPECT_TRUE(fs::exists(path_ / "superseded" / (unit_.Name() + ".json")));
}

}  // namespace
}  // namespace rtb
