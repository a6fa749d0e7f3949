#include "reference/pov_passes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/file.h"
#include "core/base/process.h"

namespace rtb {
namespace {

using testing::HasSubstr;

/// A work folder with a scene in it.
std::filesystem::path FolderWith(const std::string& sdl) {
  const auto* info = testing::UnitTest::GetInstance()->current_test_info();
  const auto folder = std::filesystem::path(testing::TempDir()) /
                      (std::string("rtb_passes_") + info->name());
  std::filesystem::remove_all(folder);
  EXPECT_TRUE(WriteFileAtomically(folder / "scene.pov", sdl).has_value());
  return folder;
}

constexpr char kWhite[] =
    "#version 3.7; global_settings { assumed_gamma 1.0 }\n"
    "#declare Used = PassSide + PassRow + PassColumn + Emitters;\n"
    "camera { location 0 } background { rgb 1 }\n";

const ReferenceRequest kSmall{4, 3, 4, 0, {}};

TEST(PovPassesTest, ThereIsOneForEveryCellOfAPixel) {
  const std::vector<PovPass> passes = PassesOf(2);
  ASSERT_EQ(passes.size(), 4u);
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(passes[static_cast<std::size_t>(i)].row, i / 2);
    EXPECT_EQ(passes[static_cast<std::size_t>(i)].column, i % 2);
  }
}

TEST(PovPassesTest, TheCommandTellsWhichPassItIs) {
  ReferenceRequest request = kSmall;
  request.emitters = 55;
  const auto command = PovPassRenderer("", request, 2).Command({1, 0});
  EXPECT_THAT(command, testing::IsSupersetOf(
                           {"+Opass_1_0.exr", "+W4", "+H3",
                            "Declare=PassSide=2", "Declare=PassRow=1",
                            "Declare=PassColumn=0", "Declare=Emitters=55"}));
}

TEST(PovPassesTest, AFinishedPassIsNotRenderedAgain) {
  if (!FindProgram("povray")) GTEST_SKIP() << "povray is not installed";
  const auto folder = FolderWith(kWhite);
  const PovPassRenderer renderer(folder, kSmall, 2);
  const Result<double> first = renderer.Render({0, 1});
  ASSERT_TRUE(first.has_value()) << first.error().ToString();
  // Without its scene POV-Ray could not render anything.
  std::filesystem::remove(folder / "scene.pov");
  const Result<double> again = renderer.Render({0, 1});
  ASSERT_TRUE(again.has_value());
  EXPECT_EQ(*again, *first);
  EXPECT_FALSE(renderer.Render({1, 1}).has_value());
  const Result<Image> pass = renderer.Read({0, 1});
  ASSERT_TRUE(pass.has_value());
  EXPECT_EQ(pass->width(), 4);
  EXPECT_EQ(pass->height(), 3);
  EXPECT_EQ(pass->at(3, 1), Rgb(1));
}

TEST(PovPassesTest, ABrokenPassIsRemovedAndSaid) {
  const auto folder = FolderWith("");
  ASSERT_TRUE(WriteFileAtomically(folder / "pass_0_1.exr", "no image"));
  const PovPassRenderer renderer(folder, kSmall, 2);
  EXPECT_FALSE(renderer.Read({0, 1}).has_value());
  EXPECT_FALSE(std::filesystem::exists(folder / "pass_0_1.exr"));
}

TEST(PovPassesTest, TellsWhatPovRaySaid) {
  if (!FindProgram("povray")) GTEST_SKIP() << "povray is not installed";
  const PovPassRenderer renderer(FolderWith("sphere { nonsense"), kSmall, 2);
  const Result<double> done = renderer.Render({0, 0});
  ASSERT_FALSE(done.has_value());
  EXPECT_EQ(done.error().kind, ErrorKind::kFailure);
  EXPECT_THAT(done.error().what, HasSubstr("nonsense"));
}

}  // namespace
}  // namespace rtb
