// The values of every key of materials read back.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "core/scene/load.h"
#include "tests/core/scene/scene_text.h"

namespace rtb {
namespace {

const std::filesystem::path kData = RTB_TEST_SOURCE_DIR "/tests/data/scenes";

/// The one material that `keys` describe.
Material Parsed(const std::string& keys) {
  const auto scene =
      ParseScene(kPreamble + "materials:\n  - {id: m, " + keys + "}\n",
                 kData / "scene.yaml");
  if (!scene) {
    ADD_FAILURE() << scene.error().ToString();
    return {};
  }
  return scene->materials[0];
}

TEST(LoadMaterialsTest, Lambertian) {
  const Material m = Parsed("type: lambertian, albedo: [0.1, 0.2, 1]");
  EXPECT_EQ(m.id, "m");
  EXPECT_EQ(m.mark.line, 5);
  EXPECT_EQ(m.mark.column, 5);
  EXPECT_EQ(std::get<Lambertian>(m.bsdf).albedo, Rgb(0.1f, 0.2f, 1));
  EXPECT_TRUE(std::holds_alternative<std::monostate>(m.texture));
  EXPECT_FALSE(m.bump.has_value());
}

TEST(LoadMaterialsTest, Mirror) {
  const Material m = Parsed("type: mirror, reflectance: [0, 0.5, 1]");
  EXPECT_EQ(std::get<Mirror>(m.bsdf).reflectance, Rgb(0, 0.5f, 1));
  const Material plain = Parsed("type: mirror");
  EXPECT_EQ(std::get<Mirror>(plain.bsdf).reflectance, Rgb(1));
}

TEST(LoadMaterialsTest, Metal) {
  const Material m =
      Parsed("type: metal, albedo: [0.9, 0.8, 0.7], roughness: 0.25");
  EXPECT_EQ(std::get<Metal>(m.bsdf).albedo, Rgb(0.9f, 0.8f, 0.7f));
  EXPECT_EQ(std::get<Metal>(m.bsdf).roughness, 0.25);
  const Material smooth = Parsed("type: metal, albedo: [1, 1, 1]");
  EXPECT_EQ(std::get<Metal>(smooth.bsdf).roughness, 0);
}

TEST(LoadMaterialsTest, Dielectric) {
  const Material m = Parsed("type: dielectric, ior: 1.33, tint: [1, 0, 1]");
  EXPECT_EQ(std::get<Dielectric>(m.bsdf).ior, 1.33);
  EXPECT_EQ(std::get<Dielectric>(m.bsdf).tint, Rgb(1, 0, 1));
  const Material clear = Parsed("type: dielectric, ior: 4");
  EXPECT_EQ(std::get<Dielectric>(clear.bsdf).tint, Rgb(1));
}

TEST(LoadMaterialsTest, Plastic) {
  const Material m =
      Parsed("type: plastic, albedo: [1, 0, 0], ior: 1.4, roughness: 1");
  EXPECT_EQ(std::get<Plastic>(m.bsdf).albedo, Rgb(1, 0, 0));
  EXPECT_EQ(std::get<Plastic>(m.bsdf).ior, 1.4);
  EXPECT_EQ(std::get<Plastic>(m.bsdf).roughness, 1);
}

TEST(LoadMaterialsTest, Phong) {
  const Material m = Parsed(
      "type: phong, albedo: [1, 0, 0], specular: [0, 1, 0], exponent: 60, "
      "reflectance: [0, 0, 1]");
  const auto& phong = std::get<Phong>(m.bsdf);
  EXPECT_EQ(phong.albedo, Rgb(1, 0, 0));
  EXPECT_EQ(phong.specular, Rgb(0, 1, 0));
  EXPECT_EQ(phong.exponent, 60);
  EXPECT_EQ(phong.reflectance, Rgb(0, 0, 1));
}

TEST(LoadMaterialsTest, EmissiveMayExceedOne) {
  const Material m = Parsed("type: emissive, radiance: [15, 0, 2]");
  EXPECT_EQ(std::get<Emissive>(m.bsdf).radiance, Rgb(15, 0, 2));
}

TEST(LoadMaterialsTest, CheckerStandsInPlaceOfTheAlbedo) {
  for (const std::string type : {"lambertian", "metal", "plastic, ior: 1.5",
                                 "phong, specular: [0, 0, 0], exponent: 1"}) {
    const Material m = Parsed(
        "texture: {type: checker, a: [1, 0, 0], b: [0, 1, 0], "
        "size: 0.5}, type: " +
        type);
    const auto& checker = std::get<CheckerTexture>(m.texture);
    EXPECT_EQ(checker.a, Rgb(1, 0, 0));
    EXPECT_EQ(checker.b, Rgb(0, 1, 0));
    EXPECT_EQ(checker.size, 0.5);
  }
}

TEST(LoadMaterialsTest, ImageTextureAndBumpAreFilesBesideTheScene) {
  const Material m = Parsed(
      "type: lambertian, texture: {type: image, file: quad.obj, "
      "scale: [4, -2]}, bump: {file: quad.obj, amount: 0.02}");
  const auto& image = std::get<ImageTexture>(m.texture);
  EXPECT_EQ(image.file, kData / "quad.obj");
  EXPECT_EQ(image.scale, V2d(4, -2));
  ASSERT_TRUE(m.bump.has_value());
  EXPECT_EQ(m.bump->file, kData / "quad.obj");
  EXPECT_EQ(m.bump->amount, 0.02);
}

}  // namespace
}  // namespace rtb
