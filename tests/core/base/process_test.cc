#include "core/base/process.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>

#include <cerrno>
#include <chrono>
#include <sstream>
#include <string>
#include <thread>

#include "core/base/file.h"
#include "tests/temp_folder.h"

namespace rtb {
namespace {

ProcessOptions Shell(const std::string& script, double timeout_seconds = 0) {
  return {{"sh", "-c", script}, "", timeout_seconds};
}

/// Whether this process has children, running or not yet reaped.
bool HasChildren() {
  return ::waitpid(-1, nullptr, WNOHANG) >= 0 || errno != ECHILD;
}

TEST(RunProcess, ReturnsBothOutputsAndTheStatus) {
  const auto result = RunProcess(Shell("echo out; echo err >&2; exit 7"));
  ASSERT_TRUE(result);
  EXPECT_EQ(result->out, "out\n");
  EXPECT_EQ(result->err, "err\n");
  EXPECT_EQ(result->exit_status, 7);
  EXPECT_FALSE(HasChildren());
}

TEST(RunProcess, PassesArgumentsUntouched) {
  const auto result =
      RunProcess({{"printf", "%s|", "a b", "$HOME", "*", "'", ""}, "", 0});
  EXPECT_EQ(result.value().out, "a b|$HOME|*|'||");
}

// A pipe holds 64 KiB: reading one output to its end before the other would
// wait for ever.
TEST(RunProcess, ReadsBothOutputsAtOnce) {
  const auto result = RunProcess(
      Shell("head -c 300000 /dev/zero >&2; head -c 300000 /dev/zero; "
            "head -c 300000 /dev/zero >&2",
            60));
  ASSERT_TRUE(result) << result.error().ToString();
  EXPECT_EQ(result->out.size(), 300000u);
  EXPECT_EQ(result->err.size(), 600000u);
}

TEST(RunProcess, StandardInputIsEmpty) {
  EXPECT_EQ(RunProcess(Shell("cat; echo end", 60)).value().out, "end\n");
}

TEST(RunProcess, SignalsAre128AndTheirNumber) {
  EXPECT_EQ(RunProcess(Shell("kill -TERM $$")).value().exit_status,
            128 + SIGTERM);
}

TEST(RunProcess, RunsInTheGivenFolder) {
  const TempFolder folder;
  ASSERT_TRUE(WriteFileAtomically(folder / "f", "here"));
  EXPECT_EQ(RunProcess({{"cat", "f"}, folder.path(), 0}).value().out, "here");
  const auto missing = RunProcess({{"cat", "f"}, folder / "missing", 0});
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().kind, ErrorKind::kFailure);
}

TEST(RunProcess, MissingProgram) {
  const TempFolder folder;
  for (const std::string& name :
       {std::string("no-such-program-at-all"), (folder / "none").string()}) {
    const auto result = RunProcess({{name}, "", 0});
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().kind, ErrorKind::kMissing);
    EXPECT_EQ(result.error().place, name);
  }
}

TEST(RunProcess, AFileThatIsNoProgramFails) {
  const TempFolder folder;
  const auto file = folder / "junk";
  ASSERT_TRUE(WriteFileAtomically(file, std::string("\x01\x02\x03", 3)));
  ASSERT_EQ(::chmod(file.c_str(), 0755), 0);
  const auto result = RunProcess({{file.string()}, "", 0});
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().kind, ErrorKind::kFailure);
}

// The grandchild would touch the file after the time is up, were it alive.
TEST(RunProcess, TimeoutKillsTheWholeGroup) {
  const TempFolder folder;
  const auto begin = std::chrono::steady_clock::now();
  const auto result = RunProcess(
      {{"sh", "-c", "(sleep 1; : > late) & wait"}, folder.path(), 0.2});
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().kind, ErrorKind::kFailure);
  EXPECT_NE(result.error().what.find("0.2 s"), std::string::npos);
  EXPECT_FALSE(HasChildren());
  std::this_thread::sleep_until(begin + std::chrono::milliseconds(1500));
  EXPECT_FALSE(std::filesystem::exists(folder / "late"));
}

TEST(RunProcess, TimeoutHoldsForOneThatClosedItsOutput) {
  const auto result = RunProcess(Shell("exec >&- 2>&-; sleep 30", 0.2));
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().kind, ErrorKind::kFailure);
  EXPECT_FALSE(HasChildren());
}

TEST(RunProcess, LivesInAGroupOfItsOwn) {
  const auto result =
      RunProcess(Shell("ps -o pgid= -p $$ || echo none; "
                       "echo $$"));
  std::string group, pid;
  std::istringstream(result.value().out) >> group >> pid;
  if (group == "none") GTEST_SKIP() << "no ps here";
  EXPECT_EQ(group, pid);
}

TEST(FindProgram, SearchesPathAndTakesPaths) {
  const auto sh = FindProgram("sh");
  ASSERT_TRUE(sh);
  EXPECT_TRUE(sh->is_absolute());
  EXPECT_EQ(FindProgram(sh->string()), sh);
  EXPECT_FALSE(FindProgram("no-such-program-at-all"));
  EXPECT_FALSE(FindProgram(""));
}

TEST(FindProgram, RefusesFoldersAndPlainFiles) {
  const TempFolder folder;
  EXPECT_FALSE(FindProgram(folder.path().string()));
  ASSERT_TRUE(WriteFileAtomically(folder / "f", "#!/bin/sh\n"));
  ASSERT_EQ(::chmod((folder / "f").c_str(), 0644), 0);
  EXPECT_FALSE(FindProgram((folder / "f").string()));
  ASSERT_EQ(::chmod((folder / "f").c_str(), 0755), 0);
  EXPECT_TRUE(FindProgram((folder / "f").string()));
}

TEST(RunProcess, ReplacesVariablesOfTheEnvironment) {
  ASSERT_EQ(::setenv("RTB_KEPT", "ours", 1), 0);
  ASSERT_EQ(::setenv("RTB_REPLACED", "ours", 1), 0);
  ProcessOptions options = Shell("echo $RTB_KEPT $RTB_REPLACED $RTB_NEW");
  options.environment = {"RTB_REPLACED=theirs", "RTB_NEW=a=b"};
  const auto result = RunProcess(options);
  ASSERT_TRUE(result);
  EXPECT_EQ(result->out, "ours theirs a=b\n");
}

}  // namespace
}  // namespace rtb
