#include "core/base/file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <thread>
#include <vector>

#include "core/base/posix.h"
#include "tests/temp_folder.h"

namespace rtb {
namespace {

namespace fs = std::filesystem;

/// Any bytes: zeros, line ends and values past 127 are among them.
std::string SomeBytes(std::size_t size) {
  std::string bytes(size, '\0');
  for (std::size_t i = 0; i < size; ++i) {
    bytes[i] = static_cast<char>((i * i + i / 256) & 0xFF);
  }
  return bytes;
}

std::ptrdiff_t EntriesIn(const fs::path& folder) {
  return std::distance(fs::directory_iterator(folder),
                       fs::directory_iterator());
}

mode_t ModeOf(const fs::path& file) {
  struct stat info {};
  EXPECT_EQ(::stat(file.c_str(), &info), 0);
  return info.st_mode & 07777;
}

TEST(ReadFile, ReturnsWhatWasWritten) {
  const TempFolder folder;
  for (const std::size_t size : {0u, 1u, 262144u, 262145u, 1000003u}) {
    const std::string bytes = SomeBytes(size);
    ASSERT_TRUE(WriteFileAtomically(folder / "f", bytes));
    EXPECT_EQ(ReadFile(folder / "f").value(), bytes) << size;
  }
}

TEST(ReadFile, TakesAsMuchAsTheLimit) {
  const TempFolder folder;
  ASSERT_TRUE(WriteFileAtomically(folder / "f", "12345"));
  EXPECT_EQ(ReadFile(folder / "f", 5).value(), "12345");
  const auto longer = ReadFile(folder / "f", 4);
  ASSERT_FALSE(longer);
  EXPECT_EQ(longer.error().kind, ErrorKind::kBadInput);
  EXPECT_NE(longer.error().what.find("4 bytes"), std::string::npos);
}

TEST(ReadFile, RefusesFoldersAndMissingFiles) {
  const TempFolder folder;
  for (const fs::path& file : {folder.path(), folder / "missing"}) {
    const auto bytes = ReadFile(file);
    ASSERT_FALSE(bytes);
    EXPECT_EQ(bytes.error().kind, ErrorKind::kBadInput);
    EXPECT_EQ(bytes.error().place, file.string());
  }
}

TEST(WriteFileAtomically, MakesFoldersAndLeavesNothingElse) {
  const TempFolder folder;
  const fs::path file = folder.path() / "a" / "b" / "c.txt";
  ASSERT_TRUE(WriteFileAtomically(file, "one"));
  ASSERT_TRUE(WriteFileAtomically(file, "two"));
  EXPECT_EQ(ReadFile(file).value(), "two");
  EXPECT_EQ(EntriesIn(file.parent_path()), 1);
}

TEST(WriteFileAtomically, KeepsTheModeAndElseAsksTheUmask) {
  const TempFolder folder;
  ASSERT_TRUE(WriteFileAtomically(folder / "new", "x"));
  const mode_t mask = ::umask(0);
  ::umask(mask);
  EXPECT_EQ(ModeOf(folder / "new"), 0666 & ~mask);
  ASSERT_EQ(::chmod((folder / "new").c_str(), 0751), 0);
  ASSERT_TRUE(WriteFileAtomically(folder / "new", "y"));
  EXPECT_EQ(ModeOf(folder / "new"), 0751u);
}

TEST(WriteFileAtomically, ReplacesRatherThanOverwrites) {
  const TempFolder folder;
  ASSERT_TRUE(WriteFileAtomically(folder / "f", "old"));
  std::ifstream reader(folder / "f");
  ASSERT_TRUE(WriteFileAtomically(folder / "f", "new"));
  // Whoever had the old file open still sees all of it.
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(reader), {}), "old");
}

TEST(WriteFileAtomically, KeepsSymbolicLinks) {
  const TempFolder folder;
  ASSERT_TRUE(WriteFileAtomically(folder / "target", "old"));
  fs::create_symlink("target", folder / "link");
  ASSERT_TRUE(WriteFileAtomically(folder / "link", "new"));
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
  EXPECT_EQ(ReadFile(folder / "target").value(), "new");
}

TEST(WriteFileAtomically, FailureLeavesNoDebris) {
  const TempFolder folder;
  ASSERT_TRUE(WriteFileAtomically(folder / "file", "kept"));
  // A file where a folder is needed: nobody, not even root, can write there.
  const auto below = WriteFileAtomically(folder / "file" / "x", "y");
  ASSERT_FALSE(below);
  EXPECT_EQ(below.error().kind, ErrorKind::kFailure);
  const auto over = WriteFileAtomically(folder.path(), "y");
  ASSERT_FALSE(over);
  EXPECT_EQ(over.error().kind, ErrorKind::kBadInput);
  EXPECT_EQ(WriteFileAtomically("", "y").error().kind, ErrorKind::kBadInput);
  EXPECT_EQ(EntriesIn(folder.path()), 1);
  EXPECT_EQ(ReadFile(folder / "file").value(), "kept");
}

TEST(WriteFileAtomically, UnwritableFolderIsAClearError) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may write anywhere";
  const TempFolder folder;
  ASSERT_EQ(::chmod(folder.path().c_str(), 0555), 0);
  const auto status = WriteFileAtomically(folder / "f", "x");
  ASSERT_EQ(::chmod(folder.path().c_str(), 0755), 0);
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().place, (folder / "f").string());
  EXPECT_FALSE(status.error().hint.empty());
}

TEST(WriteFileAtomically, WritesThroughDevices) {
  EXPECT_TRUE(WriteFileAtomically("/dev/null", "x"));
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  const auto full = WriteFileAtomically("/dev/full", "x");
  ASSERT_FALSE(full);
  EXPECT_EQ(full.error().kind, ErrorKind::kFailure);
}

TEST(WriteFileAtomically, WritesThroughPipes) {
  const TempFolder folder;
  const fs::path fifo = folder / "fifo";
  ASSERT_EQ(::mkfifo(fifo.c_str(), 0600), 0);
  // More than a pipe holds, so that it takes several writes.
  const std::string bytes = SomeBytes(300000);
  Status status;
  std::thread writer([&] { status = WriteFileAtomically(fifo, bytes); });
  const auto read = ReadFile(fifo);
  writer.join();
  EXPECT_TRUE(status);
  EXPECT_EQ(read.value(), bytes);
  EXPECT_TRUE(fs::is_fifo(fifo));
}

TEST(WriteFileAtomically, GoesOnWhereAnOpenDescriptorStands) {
  const TempFolder folder;
  const UniqueFd fd(
      ::open((folder / "f").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600));
  ASSERT_EQ(WriteAll(fd.get(), "head "), 0);
  ASSERT_TRUE(
      WriteFileAtomically("/dev/fd/" + std::to_string(fd.get()), "body "));
  ASSERT_EQ(WriteAll(fd.get(), "tail"), 0);
  EXPECT_EQ(ReadFile(folder / "f").value(), "head body tail");
}

TEST(WriteFileAtomically, ManyWritersLeaveOneWholeFile) {
  const TempFolder folder;
  std::vector<std::thread> writers;
  for (char letter = 'a'; letter < 'g'; ++letter) {
    writers.emplace_back([&folder, letter] {
      for (int i = 0; i < 5; ++i) {
        EXPECT_TRUE(
            WriteFileAtomically(folder / "f", std::string(5000, letter)));
      }
    });
  }
  for (std::thread& writer : writers) writer.join();
  const std::string bytes = ReadFile(folder / "f").value();
  EXPECT_EQ(bytes, std::string(5000, bytes.at(0)));
  EXPECT_EQ(EntriesIn(folder.path()), 1);
}

// FIPS 180-4's examples for SHA-256: the empty message and "abc".
TEST(Sha256, MatchesTheStandardsExamples) {
  EXPECT_EQ(Sha256(""),
            "e3b0c44298fc1c149afbf4c8996fb924"
            "27ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(Sha256("abc"),
            "ba7816bf8f01cfea414140de5dae2223"
            "b00361a396177a9cb410ff61f20015ad");
}

TEST(Sha256File, HashesTheBytes) {
  const TempFolder folder;
  const std::string bytes = SomeBytes(500000);
  ASSERT_TRUE(WriteFileAtomically(folder / "f", bytes));
  EXPECT_EQ(Sha256File(folder / "f").value(), Sha256(bytes));
  EXPECT_FALSE(Sha256File(folder / "missing"));
}

}  // namespace
}  // namespace rtb
