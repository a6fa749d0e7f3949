#include "core/scene/load.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace rtb {
namespace {

namespace fs = std::filesystem;

TEST(LoadSceneTest, EveryCommittedSceneLoadsAndIsRenderable) {
  int count = 0;
  for (const auto& entry :
       fs::directory_iterator(RTB_TEST_SOURCE_DIR "/scenes")) {
    if (entry.path().extension() != ".yaml") continue;
    const Result<Scene> scene = LoadScene(entry.path());
    ASSERT_TRUE(scene) << scene.error().ToString();
    EXPECT_EQ(scene->file, entry.path());
    EXPECT_TRUE(CheckRenderable(*scene));
    ++count;
  }
  EXPECT_GE(count, 2);
}

}  // namespace
}  // namespace rtb
