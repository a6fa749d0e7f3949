#include "core/base/scratch_folder.h"

#include <gtest/gtest.h>

#include <fstream>
#include <utility>

namespace rtb {
namespace {

namespace fs = std::filesystem;

TEST(ScratchFolderTest, IsPrivateAndGoesWithItsObject) {
  fs::path path;
  {
    auto folder = ScratchFolder::Make();
    ASSERT_TRUE(folder) << folder.error().ToString();
    path = folder->path();
    EXPECT_EQ(fs::status(path).permissions(), fs::perms::owner_all);
    std::ofstream(path / "file") << "text";
    const ScratchFolder moved = std::move(*folder);
    EXPECT_EQ(moved.path(), path);
    EXPECT_TRUE(fs::exists(path / "file"));
  }
  EXPECT_FALSE(fs::exists(path));
}

TEST(ScratchFolderTest, EachIsAnother) {
  const auto a = ScratchFolder::Make();
  const auto b = ScratchFolder::Make();
  ASSERT_TRUE(a && b);
  EXPECT_NE(a->path(), b->path());
}

}  // namespace
}  // namespace rtb
