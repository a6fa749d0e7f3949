#include "core/base/gzip.h"

#include <gtest/gtest.h>

#include "core/base/file.h"
#include "core/base/process.h"
#include "core/base/scratch_folder.h"

namespace rtb {
namespace {

// RFC 1952, 2.3: magic 1f 8b, method 8 (deflate), no flags (no name), time 0.
TEST(GzipTest, HasNoNameAndNoTime) {
  const std::string packed = Gzip("text");
  ASSERT_GT(packed.size(), 18u);
  EXPECT_EQ(packed.substr(0, 8), std::string("\x1f\x8b\x08\0\0\0\0\0", 8));
}

TEST(GzipTest, UnpacksToTheSameBytes) {
  const auto folder = ScratchFolder::Make();
  for (const std::string& text :
       {std::string(), std::string("a"), std::string(100000, 'x')}) {
    const auto file = folder->path() / "f.gz";
    ASSERT_TRUE(WriteFileAtomically(file, Gzip(text)));
    const auto unpacked = RunProcess({{"gzip", "-dc", file.string()}, {}, 60});
    ASSERT_TRUE(unpacked);
    EXPECT_EQ(unpacked->exit_status, 0);
    EXPECT_EQ(unpacked->out, text);
  }
  EXPECT_LT(Gzip(std::string(100000, 'x')).size(), 300u);
}

}  // namespace
}  // namespace rtb
