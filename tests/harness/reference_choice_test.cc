#include "harness/reference_choice.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/base/file.h"
#include "core/image/io.h"
#include "harness/lookup.h"
#include "reference/pov_export.h"
#include "tests/harness/temporary_folder.h"

namespace rtb {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr char kScene[] =
    "rtbench_scene: 1\n"
    "name: gray\n"
    "camera: {position: [0, 0, 0], look_at: [0, 0, -1], vfov: 40}\n"
    "background: {type: constant, color: [0.25, 0.25, 0.25]}\n";

/// A scene that shows nothing but its background, in a scene folder. Linear
/// 0.25 is code 137: 255 (1.055 * 0.25^(1/2.4) - 0.055) = 136.96.
class ChooseReferenceTest : public ::testing::Test {
 protected:
  PreparedScene Prepare(double time = 0, const std::string& more = "",
                        const std::string& integrator = "whitted") {
    SceneRequest request;
    request.options.integrator = integrator;
    request.scene = folder_.Write("scenes/gray.yaml", kScene + more).string();
    request.options.time = time;
    return std::move(PrepareScene(request).value());
  }

  /// A white reference with the provenance it should have, `changed` where a
  /// test says so.
  std::filesystem::path AddReference(
      const PreparedScene& scene, int width = 48,
      const nlohmann::json& changed = nlohmann::json::object(),
      const std::string& renderer = "povray") {
    Image image(width, 32);
    for (Rgb& pixel : image.pixels()) pixel = Rgb(1);
    const auto file = ReferenceFile(scene.file, renderer, scene.options.time);
    RTB_CHECK(WriteExr(file, image, ExrType::kFloat).has_value());
    nlohmann::json provenance = {
        {"schema", 1},
        {"renderer", renderer},
        {"scene", {{"sha256", scene.scene->sha256}}},
        {"settings", {{"time", scene.options.time}}},
        {"image", {{"sha256", Sha256File(file).value()}}}};
    provenance.merge_patch(changed);
    folder_.Write("reference/" + file.filename().string() + ".json",
                  provenance.dump());
    return file;
  }

  /// A reference that is not used by default, and an error when asked for.
  void ExpectRefused(const PreparedScene& scene, const std::string& why) {
    const auto picture = ChooseReference("", scene, raster_).value();
    EXPECT_EQ(picture.name, "self");
    EXPECT_THAT(picture.notes,
                ElementsAre(HasSubstr(why), HasSubstr("our own image")));
    const auto named = ChooseReference("povray", scene, raster_);
    ASSERT_FALSE(named.has_value());
    EXPECT_EQ(named.error().kind, ErrorKind::kBadInput);
    EXPECT_EQ(named.error().place, "--reference");
    EXPECT_THAT(named.error().what, HasSubstr(why));
    EXPECT_THAT(named.error().hint, HasSubstr("--reference=self"));
  }

  TemporaryFolder folder_;
  const PixelSize raster_{48, 32};
};

TEST_F(ChooseReferenceTest, OurOwnImageMayComeFromTheCache) {
  const PreparedScene scene = Prepare();
  const auto cache = folder_.path() / "cache";
  const auto made = ChooseReference("self", scene, raster_, cache).value();
  EXPECT_FALSE(std::filesystem::is_empty(cache));
  const auto read = ChooseReference("self", scene, raster_, cache).value();
  EXPECT_EQ(made.display.at(0, 0), read.display.at(0, 0));
  EXPECT_NEAR(read.display.at(0, 0).x, 137 / 255.0, 1e-6);
}

TEST_F(ChooseReferenceTest, RendersItselfWhereThereIsNone) {
  const auto picture = ChooseReference("", Prepare(), raster_).value();
  EXPECT_EQ(picture.name, "self");
  EXPECT_TRUE(picture.file.empty());
  EXPECT_EQ(picture.display.width(), 48);
  EXPECT_EQ(picture.display.at(47, 31), Rgb(137.0f / 255.0f));
}

// POV-Ray's images have no light between surfaces: they say nothing of paths.
TEST_F(ChooseReferenceTest, ComparesPathsWithPathsAlone) {
  const PreparedScene scene = Prepare(0, "", "path");
  AddReference(scene);
  EXPECT_EQ(ChooseReference("", scene, raster_).value().name, "self");
  EXPECT_EQ(ChooseReference("povray", scene, raster_).value().name, "povray");
  AddReference(scene, 48, nlohmann::json::object(), "cycles");
  EXPECT_EQ(ChooseReference("", scene, raster_).value().name, "cycles");
  EXPECT_EQ(ChooseReference("", Prepare(), raster_).value().name, "povray");
}

TEST_F(ChooseReferenceTest, PrefersTheCommittedOne) {
  const PreparedScene scene = Prepare();
  const auto file = AddReference(scene);
  for (const char* choice : {"", "povray"}) {
    const auto picture = ChooseReference(choice, scene, raster_).value();
    EXPECT_EQ(picture.name, "povray");
    EXPECT_EQ(picture.file, file);
    EXPECT_EQ(picture.display.at(0, 0), Rgb(1));
    EXPECT_THAT(picture.notes, IsEmpty());
  }
}

TEST_F(ChooseReferenceTest, EveryTimeHasItsOwnReference) {
  AddReference(Prepare());
  const PreparedScene later = Prepare(1.5);
  const auto self = ChooseReference("", later, raster_).value();
  EXPECT_EQ(self.name, "self");
  EXPECT_THAT(self.notes, ElementsAre(HasSubstr("our own image")));
  const auto missing = ChooseReference("povray", later, raster_);
  ASSERT_FALSE(missing.has_value());
  EXPECT_THAT(missing.error().what, HasSubstr("gray.t1.5.povray.exr"));
  const auto file = AddReference(later);
  EXPECT_EQ(file.filename(), "gray.t1.5.povray.exr");
  EXPECT_EQ(ChooseReference("", later, raster_)->file, file);
}

TEST_F(ChooseReferenceTest, RefusesWhatIsNoProvenance) {
  const PreparedScene scene = Prepare();
  const auto file = AddReference(scene);
  const std::string name = "reference/gray.povray.exr.json";
  for (const char* text : {"", "[]", "{"}) {
    folder_.Write(name, text);
    ExpectRefused(scene, "no JSON object");
  }
  folder_.Write(name, "{}");
  ExpectRefused(scene, "schema null, expected 1");
  std::filesystem::remove(file.string() + ".json");
  ExpectRefused(scene, "no provenance");
}

// A list where an object should be is no reason to end the program.
TEST_F(ChooseReferenceTest, RefusesProvenanceOfOtherThings) {
  const PreparedScene scene = Prepare();
  const std::string zeros(64, '0');
  const std::vector<std::pair<nlohmann::json, std::string>> cases = {
      {{{"schema", 2}}, "schema 2, expected 1"},
      {{{"renderer", "cycles"}}, "rendered by \"cycles\""},
      {{{"settings", {{"time", 2}}}}, "shows time 2, expected 0"},
      {{{"settings", {1}}}, "shows time null"},
      {{{"scene", {{"sha256", zeros}}}}, "another version"},
      {{{"image", {{"sha256", zeros}}}}, "not the image"}};
  for (const auto& [changed, why] : cases) {
    SCOPED_TRACE(changed.dump());
    AddReference(scene, 48, changed);
    ExpectRefused(scene, why);
  }
}

TEST_F(ChooseReferenceTest, RefusesAnImageThatChanged) {
  const PreparedScene scene = Prepare();
  const auto file = AddReference(scene);
  std::ofstream(file, std::ios::app) << "x";
  ExpectRefused(scene, "not the image");
}

// A comment changes the file, not the scene.
TEST_F(ChooseReferenceTest, BelievesTheSameSceneInOtherWords) {
  const PreparedScene scene = Prepare();
  AddReference(scene, 48,
               {{"scene", {{"sha256", std::string(64, '0')}}},
                {"sdl_sha256", Sha256(ExportPov(*scene.scene, 0).value())}});
  EXPECT_EQ(ChooseReference("", scene, raster_)->name, "povray");
}

// The scene's file names the mesh but does not hold it.
TEST_F(ChooseReferenceTest, RefusesTheReferenceOfAnotherMesh) {
  const char triangle[] = "v 0 0 -5\nv 1 0 -5\nv 0 1 -5\nf 1 2 3\n";
  folder_.Write("scenes/a.obj", triangle);
  const std::string objects = "objects: [{type: mesh, file: a.obj}]\n";
  const PreparedScene scene = Prepare(0, objects);
  AddReference(scene, 48,
               {{"sdl_sha256", Sha256(ExportPov(*scene.scene, 0).value())}});
  EXPECT_EQ(ChooseReference("", scene, raster_)->name, "povray");
  folder_.Write("scenes/a.obj", triangle + std::string("v 1 1 -5\nf 2 4 3\n"));
  const PreparedScene changed = Prepare(0, objects);
  EXPECT_EQ(changed.scene->sha256, scene.scene->sha256);
  ExpectRefused(changed, "another version");
}

TEST_F(ChooseReferenceTest, AnotherAspectSuggestsSelf) {
  const PreparedScene scene = Prepare();
  AddReference(scene, 49);
  const auto picture = ChooseReference("povray", scene, raster_);
  ASSERT_FALSE(picture.has_value());
  EXPECT_EQ(picture.error().kind, ErrorKind::kBadInput);
  EXPECT_THAT(picture.error().hint, HasSubstr("--reference=self"));
}

TEST_F(ChooseReferenceTest, AnotherSizeOfTheSameAspectIsAccepted) {
  const PreparedScene scene = Prepare();
  AddReference(scene);
  EXPECT_TRUE(ChooseReference("povray", scene, {96, 64}).has_value());
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
