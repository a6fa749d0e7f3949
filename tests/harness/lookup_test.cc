#include "harness/lookup.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/harness/temporary_folder.h"

namespace rtb {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class Lookup : public ::testing::Test {
 protected:
  std::filesystem::path Path(const std::string& name) const {
    return folder_.path() / name;
  }

  TemporaryFolder folder_;
};

TEST_F(Lookup, TriesEnvironmentThenInstalledThenBesideThenRepository) {
  folder_.Write("mine/scenes/a.yaml", "");
  folder_.Write("repo/scenes/a.yaml", "");
  folder_.Write("repo/reference/x", "");
  folder_.Write("repo/build/share/rtbench/scenes/a.yaml", "");
  folder_.Write("repo/build/bin/scenes/a.yaml", "");
  EXPECT_THAT(
      FindDataFolders(Path("repo/build/bin/rtbench"), Path("mine").string()),
      ElementsAre(Path("mine"), Path("repo/build/share/rtbench"),
                  Path("repo/build/bin"), Path("repo")));
}

TEST_F(Lookup, NamesOnlyWhatExists) {
  folder_.Write("bin/rtbench", "");
  EXPECT_THAT(FindDataFolders(Path("bin/rtbench"), Path("gone").string()),
              IsEmpty());
}

// A folder `scenes` alone is no repository: walking up stops at the one that
// has `reference` too.
TEST_F(Lookup, RepositoryHasScenesAndReference) {
  folder_.Write("repo/scenes/a.yaml", "");
  folder_.Write("repo/reference/x", "");
  folder_.Write("repo/build/scenes/b.yaml", "");
  EXPECT_THAT(FindDataFolders(Path("repo/build/dev/rtbench"), ""),
              ElementsAre(Path("repo")));
}

TEST_F(Lookup, ListsScenesByNameAndTheFirstFolderWins) {
  folder_.Write("one/scenes/b.yaml", "");
  folder_.Write("two/scenes/b.yaml", "");
  folder_.Write("two/scenes/a.yaml", "");
  folder_.Write("two/scenes/mesh.obj", "");
  const auto scenes = ListScenes({Path("one"), Path("two")});
  ASSERT_EQ(scenes.size(), 2u);
  EXPECT_EQ(scenes[0].name, "a");
  EXPECT_EQ(scenes[0].file, Path("two/scenes/a.yaml"));
  EXPECT_EQ(scenes[1].name, "b");
  EXPECT_EQ(scenes[1].file, Path("one/scenes/b.yaml"));
}

TEST_F(Lookup, NamesComeBeforeFiles) {
  folder_.Write("data/scenes/a.yaml", "");
  const auto file = folder_.Write("elsewhere/b.yaml", "");
  const DataFolders folders{Path("data")};
  EXPECT_EQ(FindScene(folders, "a").value(), Path("data/scenes/a.yaml"));
  EXPECT_EQ(FindScene(folders, file.string()).value(), file);
}

TEST_F(Lookup, UnknownScenesListTheKnownOnes) {
  folder_.Write("data/scenes/cornell.yaml", "");
  folder_.Write("data/scenes/whitted.yaml", "");
  const auto scene = FindScene({Path("data")}, "cornel");
  ASSERT_FALSE(scene.has_value());
  EXPECT_EQ(scene.error().kind, ErrorKind::kBadInput);
  EXPECT_THAT(scene.error().what, HasSubstr("'cornel'"));
  EXPECT_THAT(scene.error().what, HasSubstr("cornell, whitted"));
  EXPECT_THAT(scene.error().hint, HasSubstr("did you mean `cornell`?"));
}

TEST_F(Lookup, AFolderIsNoScene) {
  folder_.Write("data/scenes/a.yaml", "");
  EXPECT_FALSE(FindScene({Path("data")}, Path("data").string()).has_value());
  EXPECT_FALSE(FindScene({Path("data")}, "").has_value());
}

TEST_F(Lookup, ReferencesStandBesideTheScenes) {
  const auto scene = folder_.Write("data/scenes/a.yaml", "");
  EXPECT_EQ(FindReference(scene, "povray", 0), std::nullopt);
  const auto image = folder_.Write("data/reference/a.povray.exr", "");
  EXPECT_EQ(FindReference(scene, "povray", 0), image);
  EXPECT_EQ(FindReference(scene, "cycles", 0), std::nullopt);
  EXPECT_EQ(FindReference(scene, "povray", 1.5), std::nullopt);
  const auto later = folder_.Write("data/reference/a.t1.5.povray.exr", "");
  EXPECT_EQ(FindReference(scene, "povray", 1.5), later);
  EXPECT_EQ(ReferenceFile(scene, "povray", 1.5), later);
}

// A copy of a scene outside a scene folder is another scene: it must not be
// compared with the committed picture.
TEST_F(Lookup, ScenesElsewhereHaveNoReference) {
  const auto scene = folder_.Write("data/a.yaml", "");
  folder_.Write("reference/a.povray.exr", "");
  EXPECT_EQ(FindReference(scene, "povray", 0), std::nullopt);
}

}  // namespace
}  // namespace rtb
