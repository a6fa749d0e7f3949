// Good scenes: the values of every key read back.
#include "core/scene/load.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>

#include "core/base/file.h"
#include "tests/core/scene/scene_text.h"

namespace rtb {
namespace {

namespace fs = std::filesystem;

const fs::path kData = RTB_TEST_SOURCE_DIR "/tests/data/scenes";

/// The scene of the required keys and `sections`; a failed test otherwise.
Scene Parsed(const std::string& sections,
             const fs::path& file = "folder/scene.yaml") {
  const Result<Scene> scene = ParseScene(kPreamble + sections, file);
  if (!scene) {
    ADD_FAILURE() << scene.error().ToString();
    return {};
  }
  return *scene;
}

/// The same for a camera in place of the preamble's.
Camera ParsedCamera(const std::string& camera,
                    const std::string& sections = "") {
  const Result<Scene> scene = ParseScene(
      "rtbench_scene: 1\nname: t\ncamera: " + camera + "\n" + sections, "f");
  if (!scene) {
    ADD_FAILURE() << scene.error().ToString();
    return {};
  }
  return scene->camera;
}

const char* const kPaths =
    "paths: [{id: walk, points: [[1, 0, 0]], times: [0]},\n"
    "  {id: gaze, points: [[0, 1, 0]], times: [0]}]\n";

TEST(LoadSceneTest, EveryCommittedSceneLoads) {
  int count = 0;
  for (const auto& entry :
       fs::directory_iterator(RTB_TEST_SOURCE_DIR "/scenes")) {
    if (entry.path().extension() != ".yaml") continue;
    const Result<Scene> scene = LoadScene(entry.path());
    ASSERT_TRUE(scene) << scene.error().ToString();
    EXPECT_EQ(scene->file, entry.path());
    EXPECT_EQ(scene->name, entry.path().stem());
    EXPECT_EQ(scene->sha256, *Sha256File(entry.path()));
    EXPECT_THAT(scene->warnings, testing::IsEmpty());
    ++count;
  }
  EXPECT_GE(count, 2);
}

TEST(LoadSceneTest, FilesThatAreNoScenes) {
  const auto missing = LoadScene("no/such/scene.yaml");
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().kind, ErrorKind::kBadInput);
  EXPECT_THAT(missing.error().ToString(), testing::HasSubstr("no such"));
  const auto folder = LoadScene(fs::path(RTB_TEST_SOURCE_DIR) / "core");
  ASSERT_FALSE(folder);
  EXPECT_EQ(folder.error().kind, ErrorKind::kBadInput);
  EXPECT_THAT(folder.error().ToString(), testing::HasSubstr("is a folder"));
}

TEST(ParseSceneTest, DefaultsOfTheFormat) {
  const Scene scene = Parsed("");
  EXPECT_EQ(scene.name, "test");
  EXPECT_EQ(scene.description, "");
  EXPECT_EQ(scene.camera.up, V3d(0, 1, 0));
  EXPECT_TRUE(scene.camera.user_control);
  EXPECT_FALSE(scene.camera.speed.has_value());
  EXPECT_EQ(scene.camera.path, kNone);
  EXPECT_EQ(std::get<ConstantBackground>(scene.background.kind).color, Rgb(0));
  EXPECT_EQ(scene.settings.max_depth, 8);
  EXPECT_EQ(scene.settings.ambient, Rgb(0));
  EXPECT_EQ(scene.settings.exposure, 0);
  EXPECT_TRUE(scene.objects.empty());
}

TEST(ParseSceneTest, JsonIsReadToo) {
  const auto scene = ParseScene(
      "{\n\t\"rtbench_scene\": 1,\n\t\"name\": \"j\",\n\t\"camera\": "
      "{\"position\": [0, 0, 1.5e0], \"look_at\": [0, 0, 0], \"vfov\": 40},\n"
      "\t\"objects\": [\n\t\t{\"type\": \"sphere\", \"center\": [0, 0, 0], "
      "\"radius\": 1}\n\t]\n}\n",
      "scene.json");
  ASSERT_TRUE(scene) << scene.error().ToString();
  EXPECT_EQ(scene->name, "j");
  EXPECT_EQ(scene->camera.position, V3d(0, 0, 1.5));
  EXPECT_EQ(scene->objects.size(), 1u);
}

TEST(ParseSceneTest, ByteOrderMarkAndCarriageReturnsDoNotMatter) {
  std::string text = kPreamble;
  for (std::size_t i = 0; (i = text.find('\n', i)) != std::string::npos;) {
    text.replace(i, 1, "\r\n");
    i += 2;
  }
  EXPECT_TRUE(ParseScene("\xef\xbb\xbf" + text, "f"));
}

TEST(ParseSceneTest, NumbersInEveryDecimalNotation) {
  const Scene scene = Parsed(
      "objects: [{type: sphere, center: [+1, -.5, 1E-3], radius: 2.}]\n");
  EXPECT_EQ(std::get<Sphere>(scene.objects[0].shape).center,
            V3d(1, -0.5, 1e-3));
  EXPECT_EQ(std::get<Sphere>(scene.objects[0].shape).radius, 2);
}

TEST(ParseSceneTest, AliasesStandForWhatTheyName) {
  const Scene scene = Parsed(
      "settings: {ambient: &grey [0.5, 0.5, 0.5]}\n"
      "background: {type: constant, color: *grey}\n");
  EXPECT_EQ(std::get<ConstantBackground>(scene.background.kind).color,
            Rgb(0.5f));
}

TEST(ParseSceneTest, SettingsAndDescription) {
  const Scene scene = Parsed(
      "description: a line of text\n"
      "settings: {max_depth: 64, ambient: [1, 2, 3], exposure: -1.5}\n");
  EXPECT_EQ(scene.description, "a line of text");
  EXPECT_EQ(scene.settings.max_depth, 64);
  EXPECT_EQ(scene.settings.ambient, Rgb(1, 2, 3));
  EXPECT_EQ(scene.settings.exposure, -1.5);
}

TEST(ParseSceneTest, CameraWithLookAt) {
  const Camera camera = ParsedCamera(
      "{position: [1, 2, 3], look_at: [1, 2, 0], up: [1, 0, 0], vfov: 60, "
      "user_control: false, speed: 7}");
  EXPECT_EQ(camera.position, V3d(1, 2, 3));
  EXPECT_TRUE(camera.has_look_at);
  EXPECT_EQ(camera.look_at, V3d(1, 2, 0));
  EXPECT_EQ(camera.direction, V3d(0, 0, -3));  // look_at - position
  EXPECT_EQ(camera.up, V3d(1, 0, 0));
  EXPECT_EQ(camera.vfov, 60);
  EXPECT_FALSE(camera.user_control);
  EXPECT_EQ(camera.speed, 7);
}

TEST(ParseSceneTest, CameraWithDirectionAndLens) {
  const Camera camera = ParsedCamera(
      "{position: [0, 0, 0], direction: [0, 0, 2], focal_length: 0.5, "
      "sensor_height: 1}");
  EXPECT_FALSE(camera.has_look_at);
  EXPECT_EQ(camera.direction, V3d(0, 0, 2));
  EXPECT_NEAR(camera.vfov, 90, 1e-12);  // 2 atan((1 / 2) / 0.5)
}

TEST(ParseSceneTest, CameraPathsMoveTheViewAtTimeZero) {
  // Standing on what it looks at, but for the first points of its paths:
  // direction = (0, 1, 0) - (1, 0, 0).
  const Camera camera = ParsedCamera(
      "{position: [5, 5, 5], look_at: [5, 5, 5], vfov: 40, path: walk, "
      "look_path: gaze}",
      kPaths);
  EXPECT_EQ(camera.path, 0);
  EXPECT_EQ(camera.look_path, 1);
  EXPECT_EQ(camera.direction, V3d(-1, 1, 0));
}

TEST(ParseSceneTest, Backgrounds) {
  const Scene gradient = Parsed(
      "background: {type: gradient, bottom: [1, 2, 3], top: [4, 5, 6]}\n");
  const auto& kind = std::get<GradientBackground>(gradient.background.kind);
  EXPECT_EQ(kind.bottom, Rgb(1, 2, 3));
  EXPECT_EQ(kind.top, Rgb(4, 5, 6));
  EXPECT_EQ(gradient.background.mark.line, 4);
  EXPECT_EQ(gradient.background.mark.column, 13);
  const Scene image = Parsed("background: {type: image, file: quad.obj}\n",
                             kData / "scene.yaml");
  EXPECT_EQ(std::get<ImageBackground>(image.background.kind).file,
            kData / "quad.obj");
}

TEST(ParseSceneTest, Lights) {
  const Scene scene = Parsed(
      "lights:\n"
      "  - {id: a, type: point, position: [1, 2, 3], intensity: [4, 5, 6]}\n"
      "  - {type: point, position: [0, 0, 0], intensity: [1, 1, 1],\n"
      "     falloff: none, path: gaze}\n"
      "  - {id: c, type: directional, direction: [0, -1, 0],\n"
      "     irradiance: [1, 2, 3]}\n"
      "  - {id: d, type: spot, position: [1, 0, 0], direction: [0, 0, 1],\n"
      "     intensity: [9, 9, 9], cone: 60, penumbra: 30}\n"
      "  - {id: e, type: quad, corner: [1, 1, 1],\n"
      "     edges: [[1, 0, 0], [0, 0, 2]], radiance: [3, 3, 3], samples: 9}\n"
      "  - {id: f, type: sphere, center: [0, 1, 0], radius: 0.5,\n"
      "     radiance: [2, 2, 2], samples: 4}\n" +
      std::string(kPaths));
  ASSERT_EQ(scene.lights.size(), 6u);
  const auto& point = std::get<PointLight>(scene.lights[0].kind);
  EXPECT_EQ(scene.lights[0].id, "a");
  EXPECT_EQ(scene.lights[0].mark.line, 5);
  EXPECT_EQ(point.position, V3d(1, 2, 3));
  EXPECT_EQ(point.intensity, Rgb(4, 5, 6));
  EXPECT_TRUE(point.inverse_square);
  EXPECT_FALSE(std::get<PointLight>(scene.lights[1].kind).inverse_square);
  EXPECT_EQ(scene.lights[1].path, 1);
  const auto& sun = std::get<DirectionalLight>(scene.lights[2].kind);
  EXPECT_EQ(sun.direction, V3d(0, -1, 0));
  EXPECT_EQ(sun.irradiance, Rgb(1, 2, 3));
  const auto& spot = std::get<SpotLight>(scene.lights[3].kind);
  EXPECT_EQ(spot.cone, 60);
  EXPECT_EQ(spot.penumbra, 30);
  const auto& quad = std::get<QuadLight>(scene.lights[4].kind);
  EXPECT_EQ(quad.edges[1], V3d(0, 0, 2));
  EXPECT_EQ(quad.samples, 9);
  const auto& sphere = std::get<SphereLight>(scene.lights[5].kind);
  EXPECT_EQ(sphere.radius, 0.5);
  EXPECT_EQ(sphere.samples, 4);
}

TEST(ParseSceneTest, Paths) {
  const Scene scene = Parsed(
      "paths:\n"
      "  - {id: a, points: [[0, 0, 0], [1, 0, 0], [2, 0, 0]], duration: 6}\n"
      "  - {id: b, points: [[0, 0, 0], [1, 0, 0], [2, 0, 0]], duration: 6,\n"
      "     loop: true, interpolation: catmull_rom}\n"
      "  - {id: c, points: [[0, 0, 0], [1, 2, 3]], times: [0, 2.5]}\n"
      "  - {id: d, points: [[1, 2, 3]], duration: 2}\n");
  ASSERT_EQ(scene.paths.size(), 4u);
  // Two segments of 3 s; with the way back three of 2 s.
  EXPECT_THAT(scene.paths[0].times, testing::ElementsAre(0, 3, 6));
  EXPECT_EQ(scene.paths[0].interpolation, Path::Interpolation::kLinear);
  EXPECT_THAT(scene.paths[1].times, testing::ElementsAre(0, 2, 4));
  EXPECT_TRUE(scene.paths[1].loop);
  EXPECT_EQ(scene.paths[1].duration, 6);
  EXPECT_EQ(scene.paths[1].interpolation, Path::Interpolation::kCatmullRom);
  EXPECT_THAT(scene.paths[2].times, testing::ElementsAre(0, 2.5));
  EXPECT_EQ(scene.paths[2].duration, 2.5);
  EXPECT_EQ(scene.paths[2].points[1], V3d(1, 2, 3));
  EXPECT_THAT(scene.paths[3].times, testing::ElementsAre(0));
}

}  // namespace
}  // namespace rtb
