/// @file
/// Scenes that POV-Ray would draw otherwise: the exporter refuses each.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reference/pov_export.h"
#include "tests/reference/scene_maker.h"

namespace rtb {
namespace {

using testing::HasSubstr;

/// A scene with something that POV-Ray does otherwise, and its name.
struct Refusal {
  const char* name;
  const char* message;
  void (*add)(Scene*);
};

void PrintTo(const Refusal& refusal, std::ostream* out) {
  *out << refusal.name;
}

Texture Picture() { return ImageTexture{"brick.png", V2d(1, 1)}; }

void AddSphereOf(Scene* scene, decltype(Material::bsdf) bsdf,
                 Texture texture = {}) {
  const Index material = AddMaterial(scene, bsdf, texture);
  AddObject(scene, Sphere{V3d(0, 0, -5), 1}, material);
}

const Refusal kRefusals[] = {
    {"Plastic", "`type: plastic`", [](Scene* s) { AddSphereOf(s, Plastic{}); }},
    {"RoughMetal", "`roughness`",
     [](Scene* s) {
       AddSphereOf(s, Metal{Rgb(1), 0.1});
     }},
    {"ColoredHighlight", "a colored `specular`",
     [](Scene* s) {
       AddSphereOf(s, Phong{Rgb(1), Rgb(1, 0, 0), 9, Rgb(0)});
     }},
    {"ImageTexture", "an image `texture`",
     [](Scene* s) { AddSphereOf(s, Lambertian{}, Picture()); }},
    {"Bump", "`bump`",
     [](Scene* s) {
       AddSphereOf(s, Lambertian{});
       s->materials[0].bump = BumpMap{"bump.png", 1};
     }},
    {"ImageBackground", "an image `background`",
     [](Scene* s) { s->background.kind = ImageBackground{"sky.exr"}; }},
    {"GlassDisk", "an open disk",
     [](Scene* s) { AddObject(s, Disk{}, AddMaterial(s, Dielectric{})); }},
    {"OpenGlass", "a surface that is not closed and outward",
     [](Scene* s) {
       const Index glass = AddMaterial(s, Dielectric{});
       AddObject(s, Quad{V3d(0), {V3d(1, 0, 0), V3d(0, 1, 0)}}, glass);
     }},
    {"NestedGlass", "objects that overlap",
     [](Scene* s) {
       AddSphereOf(s, Dielectric{});
       AddObject(s, Sphere{V3d(0, 0, -5), 0.5}, 0);
     }},
};

class PovRefusalTest : public testing::TestWithParam<Refusal> {};

TEST_P(PovRefusalTest, NamesWhatPovRayCannotExpress) {
  Scene scene = MakeScene();
  GetParam().add(&scene);
  const Result<std::string> text = ExportPov(scene, 0);
  ASSERT_FALSE(text.has_value());
  EXPECT_EQ(text.error().kind, ErrorKind::kBadInput);
  EXPECT_THAT(text.error().what, HasSubstr("POV-Ray cannot express"));
  EXPECT_THAT(text.error().what, HasSubstr(GetParam().message));
  EXPECT_THAT(text.error().place, HasSubstr("made.yaml:"));
}

INSTANTIATE_TEST_SUITE_P(All, PovRefusalTest, testing::ValuesIn(kRefusals),
                         [](const auto& test) {
                           return std::string(test.param.name);
                         });

}  // namespace
}  // namespace rtb
