#include "core/base/manifest.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sched.h>

#include <chrono>
#include <ctime>
#include <filesystem>
#include <string>
#include <vector>

#include "core/base/file.h"
#include "core/base/process.h"
#include "tests/temp_folder.h"

namespace rtb {
namespace {

using ::testing::HasSubstr;
using ::testing::MatchesRegex;
using ::testing::Not;

TEST(BuildInfo, SaysHowItWasBuilt) {
  const BuildInfo info = GetBuildInfo();
  EXPECT_THAT(info.version, MatchesRegex("[0-9]+\\.[0-9]+\\.[0-9]+"));
  EXPECT_THAT(info.commit, MatchesRegex("[0-9a-f]{40}|[0-9a-f]{64}|unknown"));
  EXPECT_THAT(info.compiler, MatchesRegex("[A-Za-z]+ [0-9.]+"));
  EXPECT_THAT(info.flags, HasSubstr("-ffp-contract=off"));
  EXPECT_THAT(info.flags, Not(HasSubstr(";")));
}

/// A repository, and what the build's script makes of it.
class CommitTest : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!FindProgram("git") || !FindProgram("cmake")) {
      GTEST_SKIP() << "needs git and cmake";
    }
    ASSERT_TRUE(WriteFileAtomically(source_ / "file", "one"));
  }

  std::string Git(const std::vector<std::string>& words) {
    // A hook's variables would lead git to the hook's repository.
    std::vector<std::string> argv = {"env",
                                     "-u",
                                     "GIT_DIR",
                                     "-u",
                                     "GIT_INDEX_FILE",
                                     "-u",
                                     "GIT_WORK_TREE",
                                     "git",
                                     "-c",
                                     "user.name=n",
                                     "-c",
                                     "user.email=e",
                                     "-c",
                                     "commit.gpgsign=false"};
    argv.insert(argv.end(), words.begin(), words.end());
    const auto result = RunProcess({argv, source_, 60}).value();
    EXPECT_EQ(result.exit_status, 0) << result.err;
    return result.out;
  }

  void Commit() {
    Git({"init", "--quiet"});
    Git({"add", "file"});
    Git({"commit", "--quiet", "--no-verify", "--message=one"});
  }

  /// What the script writes about `source`.
  std::string Ask(const std::filesystem::path& source,
                  const std::string& git = FindProgram("git")->string()) {
    const auto result =
        RunProcess({{"cmake", "-DGIT=" + git, "-DSOURCE=" + source.string(),
                     "-DOUTPUT=" + output_.string(), "-P",
                     RTB_TEST_SOURCE_DIR "/cmake/WriteCommit.cmake"},
                    "",
                    60});
    EXPECT_EQ(result.value().exit_status, 0) << result->err;
    return ReadFile(output_).value();
  }

  static std::string Expected(const std::string& commit, const char* dirty) {
    return "// Written in every build.\nconstexpr char kCommit[] = \"" +
           commit + "\";\nconstexpr bool kDirty = " + dirty + ";\n";
  }

  TempFolder folder_;
  const std::filesystem::path source_ = folder_ / "source";
  const std::filesystem::path output_ = folder_ / "commit.inc";
};

TEST_F(CommitTest, IsTheHeadAndWhetherTrackedFilesDiffer) {
  Commit();
  const std::string head = Git({"rev-parse", "HEAD"}).substr(0, 40);
  EXPECT_EQ(Ask(source_), Expected(head, "false"));
  ASSERT_TRUE(WriteFileAtomically(source_ / "results.json", "{}"));
  EXPECT_EQ(Ask(source_), Expected(head, "false"));
  ASSERT_TRUE(WriteFileAtomically(source_ / "file", "two"));
  EXPECT_EQ(Ask(source_), Expected(head, "true"));
}

TEST_F(CommitTest, IsUnknownOutsideARepositoryOfItsOwn) {
  EXPECT_EQ(Ask(source_), Expected("unknown", "false"));
  Commit();
  std::filesystem::create_directory(source_ / "below");
  EXPECT_EQ(Ask(source_ / "below"), Expected("unknown", "false"));
  EXPECT_EQ(Ask(source_, ""), Expected("unknown", "false"));
}

// A file that is not written again rebuilds nothing.
TEST_F(CommitTest, WritesOnlyWhatChanged) {
  Commit();
  Ask(source_);
  const auto long_ago =
      std::filesystem::file_time_type::clock::now() - std::chrono::hours(1);
  std::filesystem::last_write_time(output_, long_ago);
  const auto before = std::filesystem::last_write_time(output_);
  Ask(source_);
  EXPECT_EQ(std::filesystem::last_write_time(output_), before);
  ASSERT_TRUE(WriteFileAtomically(source_ / "file", "two"));
  Ask(source_);
  EXPECT_NE(std::filesystem::last_write_time(output_), before);
}

TEST(HostInfo, DescribesTheMachine) {
  const HostInfo host = GetHostInfo();
  EXPECT_FALSE(host.cpu_model.empty());
  EXPECT_FALSE(host.os.empty());
  EXPECT_THAT(host.os, Not(HasSubstr("\"")));
  EXPECT_FALSE(host.hostname.empty());
  EXPECT_GE(host.cores, 1);
  EXPECT_GE(host.load_1min, 0);
}

TEST(HostInfo, AgreesWithOtherPrograms) {
  const auto uname = RunProcess({{"uname", "-sr"}, "", 0});
  if (uname) {
    EXPECT_EQ(GetHostInfo().kernel + "\n", uname->out);
  }
}

TEST(HostInfo, CountsTheCoresThatThisProcessMayUse) {
  cpu_set_t before, one;
  ASSERT_EQ(::sched_getaffinity(0, sizeof before, &before), 0);
  EXPECT_EQ(GetHostInfo().cores, CPU_COUNT(&before));
  int first = 0;
  while (!CPU_ISSET(first, &before)) ++first;
  CPU_ZERO(&one);
  CPU_SET(first, &one);
  ASSERT_EQ(::sched_setaffinity(0, sizeof one, &one), 0);
  EXPECT_EQ(GetHostInfo().cores, 1);
  ASSERT_EQ(::sched_setaffinity(0, sizeof before, &before), 0);
}

TEST(UtcNow, IsNowInTheFormat) {
  const std::time_t before = std::time(nullptr);
  const std::string text = UtcNow();
  const std::time_t after = std::time(nullptr);
  std::tm parts{};
  ASSERT_STREQ(::strptime(text.c_str(), "%Y-%m-%dT%H:%M:%SZ", &parts), "");
  EXPECT_EQ(text.size(), 20u);
  EXPECT_GE(::timegm(&parts), before);
  EXPECT_LE(::timegm(&parts), after);
}

}  // namespace
}  // namespace rtb
