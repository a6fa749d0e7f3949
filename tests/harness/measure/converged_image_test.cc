#include "harness/measure/converged_image.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <vector>

#include "core/image/io.h"
#include "tests/harness/temporary_folder.h"

namespace rtb {
namespace {

using testing::HasSubstr;

constexpr char kScene[] =
    "rtbench_scene: 1\n"
    "name: edge\n"
    "camera: {position: [0, 0, 0], look_at: [0, 0, -1], vfov: 40}\n"
    "background: {type: constant, color: [0.25, 0.5, 0]}\n"
    "materials: [{id: m, type: emissive, radiance: [1, 1, 1]}]\n"
    "objects: [{type: sphere, center: [0, 0, -3], radius: 0.5, material: m}]\n";

class ConvergedImageTest : public testing::Test {
 protected:
  PreparedScene Prepare(const std::string& text = kScene) const {
    SceneRequest request;
    request.scene = folder_.Write("edge.yaml", text).string();
    return std::move(PrepareScene(request).value());
  }

  std::vector<std::filesystem::path> Cached() const {
    std::vector<std::filesystem::path> files;
    if (!std::filesystem::exists(cache_)) return files;
    for (const auto& entry : std::filesystem::directory_iterator(cache_)) {
      files.push_back(entry.path());
    }
    return files;
  }

  TemporaryFolder folder_;
  std::filesystem::path cache_ = folder_.path() / "cache";
};

bool Same(const Image& a, const Image& b) {
  return std::ranges::equal(a.pixels(), b.pixels());
}

TEST_F(ConvergedImageTest, IsTheSameFromTheCache) {
  const PreparedScene scene = Prepare();
  const Image image = ConvergedImage(scene, 0, {12, 8}, "").value();
  EXPECT_TRUE(Cached().empty());
  const Image made = ConvergedImage(scene, 0, {12, 8}, cache_).value();
  ASSERT_EQ(Cached().size(), 1u);
  const Image read = ConvergedImage(scene, 0, {12, 8}, cache_).value();
  EXPECT_TRUE(Same(image, made));
  EXPECT_TRUE(Same(image, read));
  EXPECT_EQ(Cached().size(), 1u);
}

TEST_F(ConvergedImageTest, ReadsWhatTheCacheHolds) {
  const PreparedScene scene = Prepare();
  ASSERT_TRUE(ConvergedImage(scene, 0, {12, 8}, cache_).has_value());
  Image marked(12, 8);
  marked.at(3, 3) = Rgb(7);
  ASSERT_TRUE(WriteExr(Cached().at(0), marked, ExrType::kFloat).has_value());
  EXPECT_TRUE(Same(ConvergedImage(scene, 0, {12, 8}, cache_).value(), marked));
}

TEST_F(ConvergedImageTest, MakesAnewWhatIsDamaged) {
  const PreparedScene scene = Prepare();
  const Image image = ConvergedImage(scene, 0, {12, 8}, cache_).value();
  std::filesystem::resize_file(Cached().at(0), 100);
  EXPECT_TRUE(Same(ConvergedImage(scene, 0, {12, 8}, cache_).value(), image));
  EXPECT_GT(std::filesystem::file_size(Cached().at(0)), 100u);
}

TEST_F(ConvergedImageTest, EveryInputMakesAFileOfItsOwn) {
  PreparedScene scene = Prepare();
  ASSERT_TRUE(ConvergedImage(scene, 0, {12, 8}, cache_).has_value());
  ASSERT_TRUE(ConvergedImage(scene, 1, {12, 8}, cache_).has_value());
  ASSERT_TRUE(ConvergedImage(scene, 0, {6, 4}, cache_).has_value());
  EXPECT_EQ(Cached().size(), 3u);
  scene.options.integrator = "path";
  ASSERT_TRUE(ConvergedImage(scene, 0, {6, 4}, cache_).has_value());
  EXPECT_EQ(Cached().size(), 4u);
  scene = Prepare(std::string(kScene) + "settings: {max_depth: 2}\n");
  ASSERT_TRUE(ConvergedImage(scene, 0, {6, 4}, cache_).has_value());
  EXPECT_EQ(Cached().size(), 5u);
}

// The picture that is approached does not change with the run's own options.
TEST_F(ConvergedImageTest, RunsShareOneImage) {
  PreparedScene scene = Prepare();
  ASSERT_TRUE(ConvergedImage(scene, 0, {12, 8}, cache_).has_value());
  scene.options.seed = 9;
  scene.options.spp = 4;
  scene.options.max_depth = 1;
  scene.options.threads = 1;
  scene.exposure = 2;
  ASSERT_TRUE(ConvergedImage(scene, 0, {12, 8}, cache_).has_value());
  EXPECT_EQ(Cached().size(), 1u);
}

TEST_F(ConvergedImageTest, ACacheThatCannotBeWrittenIsAnError) {
  const auto file = folder_.Write("file", "");
  const auto image = ConvergedImage(Prepare(), 0, {6, 4}, file / "cache");
  ASSERT_FALSE(image.has_value());
  EXPECT_THAT(image.error().hint, HasSubstr("RTBENCH_CACHE"));
}

}  // namespace
}  // namespace rtb
