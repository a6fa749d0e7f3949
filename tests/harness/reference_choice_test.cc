#include "harness/reference_choice.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/image/io.h"
#include "tests/harness/temporary_folder.h"

namespace rtb {
namespace {

using ::testing::HasSubstr;

constexpr char kScene[] =
    "rtbench_scene: 1\n"
    "name: gray\n"
    "camera: {position: [0, 0, 0], look_at: [0, 0, -1], vfov: 40}\n"
    "background: {type: constant, color: [0.25, 0.25, 0.25]}\n";

/// A scene that shows nothing but its background, in a scene folder. Linear
/// 0.25 is code 137: 255 (1.055 * 0.25^(1/2.4) - 0.055) = 136.96.
class ChooseReferenceTest : public ::testing::Test {
 protected:
  PreparedScene Prepare(double time = 0) {
    SceneRequest request;
    request.scene = folder_.Write("scenes/gray.yaml", kScene).string();
    request.options.time = time;
    return std::move(PrepareScene(request).value());
  }

  std::filesystem::path AddReference(float value, int width = 48) {
    Image image(width, 32);
    for (Rgb& pixel : image.pixels()) pixel = Rgb(value);
    const auto file = folder_.path() / "reference" / "gray.povray.exr";
    RTB_CHECK(WriteExr(file, image, ExrType::kFloat).has_value());
    return file;
  }

  void AddProvenance(const std::string& scene_sha256) {
    folder_.Write("reference/gray.povray.exr.json",
                  R"({"scene": {"sha256": ")" + scene_sha256 + "\"}}");
  }

  TemporaryFolder folder_;
  const PixelSize raster_{48, 32};
};

TEST_F(ChooseReferenceTest, RendersItselfWhereThereIsNone) {
  const auto picture = ChooseReference("", Prepare(), raster_).value();
  EXPECT_EQ(picture.name, "self");
  EXPECT_TRUE(picture.file.empty());
  EXPECT_EQ(picture.display.width(), 48);
  EXPECT_EQ(picture.display.at(47, 31), Rgb(137.0f / 255.0f));
}

TEST_F(ChooseReferenceTest, PrefersTheCommittedOne) {
  const auto file = AddReference(1);
  const auto picture = ChooseReference("", Prepare(), raster_).value();
  EXPECT_EQ(picture.name, "povray");
  EXPECT_EQ(picture.file, file);
  EXPECT_EQ(picture.display.at(0, 0), Rgb(1));
}

TEST_F(ChooseReferenceTest, ReferencesShowTimeZeroOnly) {
  AddReference(1);
  const PreparedScene later = Prepare(1.5);
  EXPECT_EQ(ChooseReference("", later, raster_)->name, "self");
  const auto picture = ChooseReference("povray", later, raster_);
  ASSERT_FALSE(picture.has_value());
  EXPECT_THAT(picture.error().what, HasSubstr("time 0"));
}

TEST_F(ChooseReferenceTest, BelievesProvenanceOfTheSameScene) {
  AddReference(1);
  const PreparedScene scene = Prepare();
  AddProvenance(scene.scene->sha256);
  EXPECT_EQ(ChooseReference("", scene, raster_)->name, "povray");
}

TEST_F(ChooseReferenceTest, RefusesProvenanceOfAnotherScene) {
  AddReference(1);
  AddProvenance(std::string(64, '0'));
  const PreparedScene scene = Prepare();
  EXPECT_EQ(ChooseReference("", scene, raster_)->name, "self");
  const auto picture = ChooseReference("povray", scene, raster_);
  ASSERT_FALSE(picture.has_value());
  EXPECT_THAT(picture.error().what, HasSubstr("another version"));
}

TEST_F(ChooseReferenceTest, AnotherAspectSuggestsSelf) {
  AddReference(1, 49);
  const auto picture = ChooseReference("povray", Prepare(), raster_);
  ASSERT_FALSE(picture.has_value());
  EXPECT_EQ(picture.error().kind, ErrorKind::kBadInput);
  EXPECT_THAT(picture.error().hint, HasSubstr("--reference=self"));
}

TEST_F(ChooseReferenceTest, AnotherSizeOfTheSameAspectIsAccepted) {
  AddReference(1);
  EXPECT_TRUE(ChooseReference("povray", Prepare(), {96, 64}).has_value());
}

TEST_F(ChooseReferenceTest, MissingOnesAreErrors) {
  for (const char* choice : {"povray", "cycles", "gone.exr"}) {
    const auto picture = ChooseReference(choice, Prepare(), raster_);
    ASSERT_FALSE(picture.has_value()) << choice;
    EXPECT_EQ(picture.error().kind, ErrorKind::kBadInput);
  }
}

}  // namespace
}  // namespace rtb
