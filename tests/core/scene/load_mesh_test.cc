// Meshes of scenes: what entries of Scene::meshes hold, and who shares them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "core/base/file.h"
#include "core/scene/load.h"
#include "tests/core/scene/mesh_shapes.h"
#include "tests/core/scene/scene_text.h"

namespace rtb {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

const std::filesystem::path kData = RTB_TEST_SOURCE_DIR "/tests/data/scenes";

Result<Scene> Parse(const std::string& objects,
                    const std::filesystem::path& folder = kData) {
  return ParseScene(kPreamble + "objects:\n" + objects, folder / "s.yaml");
}

/// The entry of each object, in order.
std::vector<Index> Entries(const Scene& scene) {
  std::vector<Index> entries;
  for (const Object& object : scene.objects) {
    entries.push_back(std::get<Mesh>(object.shape).data);
  }
  return entries;
}

TEST(LoadMeshTest, TheKeysOfAMesh) {
  const auto scene = Parse(
      "  - {type: mesh, file: quad.obj, smooth: false, subdivide: 2}\n"
      "  - {type: mesh, file: ../scenes/quad.obj}\n");
  ASSERT_TRUE(scene) << scene.error().ToString();
  const auto& first = std::get<Mesh>(scene->objects[0].shape);
  EXPECT_EQ(first.file, kData / "quad.obj");
  EXPECT_FALSE(first.smooth);
  EXPECT_EQ(first.subdivide, 2);
  const auto& second = std::get<Mesh>(scene->objects[1].shape);
  EXPECT_TRUE(second.smooth);
  EXPECT_EQ(second.subdivide, 0);
  EXPECT_THAT(Entries(*scene), ElementsAre(0, 1));
  EXPECT_THAT(scene->meshes[0].triangles, SizeIs(32));  // 2 * 4^2
  EXPECT_THAT(scene->meshes[1].triangles, SizeIs(2));
}

TEST(LoadMeshTest, EqualFileSmoothAndSubdivideShareAnEntry) {
  const auto scene = Parse(
      "  - {type: mesh, file: smooth.obj}\n"
      "  - {type: mesh, file: smooth.obj, smooth: false}\n"
      "  - {type: mesh, file: ../scenes/smooth.obj, scale: 3}\n"
      "  - {type: mesh, file: smooth.obj, subdivide: 1}\n"
      "  - {type: mesh, file: smooth.obj, smooth: false, subdivide: 1}\n"
      "  - {type: mesh, file: smooth.obj, smooth: true, subdivide: 1}\n");
  ASSERT_TRUE(scene) << scene.error().ToString();
  EXPECT_THAT(Entries(*scene), ElementsAre(0, 1, 0, 2, 3, 2));
  ASSERT_THAT(scene->meshes, SizeIs(4));
  // With the file's normals, without, and with the limit surface's.
  EXPECT_THAT(scene->meshes[0].normals, SizeIs(5));
  EXPECT_THAT(scene->meshes[1].normals, IsEmpty());
  EXPECT_EQ(scene->meshes[0].positions, scene->meshes[1].positions);
  EXPECT_EQ(scene->meshes[0].uvs, scene->meshes[1].uvs);
  EXPECT_EQ(scene->meshes[2].normals.size(), scene->meshes[2].positions.size());
  EXPECT_THAT(scene->meshes[3].normals, IsEmpty());
  EXPECT_THAT(scene->meshes[3].triangles, SizeIs(8));
}

/// A folder with one OBJ file, removed again.
class LoadMeshFileTest : public testing::Test {
 protected:
  void Write(const std::string& obj) {
    folder_ = std::filesystem::path(testing::TempDir()) /
              (std::string("rtb_mesh_") +
               testing::UnitTest::GetInstance()->current_test_info()->name());
    std::filesystem::create_directories(folder_);
    ASSERT_TRUE(WriteFileAtomically(folder_ / "m.obj", obj));
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path folder_;
};

TEST_F(LoadMeshFileTest, WarningsOfAFileAreGivenOnce) {
  Write("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 1 2\n");
  const auto scene = Parse(
      "  - {type: mesh, file: m.obj}\n"
      "  - {type: mesh, file: m.obj, subdivide: 1}\n"
      "  - {type: mesh, file: m.obj, smooth: false}\n",
      folder_);
  ASSERT_TRUE(scene) << scene.error().ToString();
  EXPECT_THAT(scene->meshes, SizeIs(3));
  EXPECT_THAT(scene->warnings, ElementsAre(HasSubstr("m.obj: 1 triangles")));
}

TEST_F(LoadMeshFileTest, TrianglesThatVanishInSubdivisionAreReported) {
  // The smallest floats: between 0 and 1 (in units of 2^-149) is nothing.
  Write(
      "v 0 0 0\nv 1.4e-45 0 0\nv 0 1.4e-45 0\n"
      "v 1 0 0\nv 2 0 0\nv 1 1 0\nf 1 2 3\nf 4 5 6\n");
  const auto scene =
      Parse("  - {type: mesh, file: m.obj, subdivide: 1}\n", folder_);
  ASSERT_TRUE(scene) << scene.error().ToString();
  EXPECT_LT(scene->meshes[0].triangles.size(), 8u);
  EXPECT_GE(scene->meshes[0].triangles.size(), 4u);
  EXPECT_THAT(scene->warnings,
              ElementsAre(HasSubstr("dropped after `subdivide: 1`")));
}

TEST_F(LoadMeshFileTest, AMeshThatWouldGetTooLargeIsAnError) {
  std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  for (int i = 0; i < 16385; ++i) obj += "f 1 2 3\n";
  Write(obj);
  const auto scene =
      Parse("  - {type: mesh, file: m.obj, subdivide: 6}\n", folder_);
  ASSERT_FALSE(scene);
  EXPECT_EQ(scene.error().kind, ErrorKind::kBadInput);
  EXPECT_THAT(scene.error().place, HasSubstr("s.yaml:5:"));
  EXPECT_THAT(scene.error().ToString(),
              HasSubstr("m.obj: `subdivide: 6` makes 16385 x 4096 triangles"));
}

}  // namespace
}  // namespace rtb
