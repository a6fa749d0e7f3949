#include "harness/inputs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/file.h"
#include "tests/harness/temporary_folder.h"

namespace rtb {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

Object MeshObject(const std::filesystem::path& file) {
  Object object;
  object.shape = Mesh{file};
  return object;
}

TEST(SceneInputs, NamesEveryFileOfTheSceneOnce) {
  const TemporaryFolder folder;
  const auto a = folder.Write("a.obj", "a");
  const auto b = folder.Write("b.obj", "b");
  const auto sky = folder.Write("sky.exr", "sky");
  const auto wood = folder.Write("wood.png", "wood");
  const auto bump = folder.Write("bump.png", "bump");
  Scene scene;
  scene.file = "somewhere/s.yaml";
  scene.sha256 = "of the scene";
  scene.background.kind = ImageBackground{sky};
  Material material;
  material.texture = ImageTexture{wood};
  material.bump = BumpMap{bump, 1};
  scene.materials = {material, material};
  Object group;
  group.shape = Group{};
  group.children = {MeshObject(b), MeshObject(a)};
  scene.objects = {MeshObject(a), group};
  EXPECT_THAT(SceneInputs(scene).value(),
              ElementsAre(InputFile{"scene", "s.yaml", "of the scene"},
                          InputFile{"mesh", "a.obj", Sha256("a")},
                          InputFile{"mesh", "b.obj", Sha256("b")},
                          InputFile{"image", "sky.exr", Sha256("sky")},
                          InputFile{"image", "wood.png", Sha256("wood")},
                          InputFile{"image", "bump.png", Sha256("bump")}));
}

std::vector<std::string> FontNames(const std::set<char32_t>& glyphs,
                                   const DecodeOptions& options) {
  std::vector<std::string> names;
  const auto inputs = FontInputs(glyphs, options).value();
  for (const InputFile& input : inputs) {
    EXPECT_EQ(input.role, "font");
    EXPECT_EQ(input.sha256.size(), 64u);
    names.push_back(input.name);
  }
  return names;
}

// Half blocks have exact shapes; letters have none, and the monospaced font
// lacks braille patterns.
TEST(FontInputs, NamesTheFontsThatDecodingOpens) {
  const char mono[] = "DejaVuSansMono.ttf";
  const char sans[] = "DejaVuSans.ttf";
  DecodeOptions options;
  EXPECT_THAT(FontNames({U'▄', U' '}, options), IsEmpty());
  EXPECT_THAT(FontNames({U'▄', U'x'}, options), ElementsAre(mono));
  EXPECT_THAT(FontNames({U'⠁'}, options), ElementsAre(mono, sans));
  options.masks = MaskSource::kFont;
  EXPECT_THAT(FontNames({U'▄'}, options), ElementsAre(mono));
}

TEST(FontInputs, AFontThatIsNotNeededIsNotNamed) {
  DecodeOptions options;
  options.font = FontChain({}).back();
  EXPECT_THAT(FontNames({U'▄'}, options), IsEmpty());
  EXPECT_THAT(FontNames({U'⠁'}, options), ElementsAre("DejaVuSans.ttf"));
}

TEST(CheckFont, AsksForTheGivenFont) {
  DecodeOptions options;
  EXPECT_TRUE(CheckFont(options).has_value());
  options.font = "gone.ttf";
  const Status found = CheckFont(options);
  ASSERT_FALSE(found.has_value());
  EXPECT_EQ(found.error().kind, ErrorKind::kBadInput);
  EXPECT_EQ(found.error().place, "gone.ttf");
}

}  // namespace
}  // namespace rtb
