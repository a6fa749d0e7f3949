#include "reference/pov_bands.h"

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
                      (std::string("rtb_bands_") + info->name());
  std::filesystem::remove_all(folder);
  EXPECT_TRUE(WriteFileAtomically(folder / "scene.pov", sdl).has_value());
  return folder;
}

constexpr char kWhite[] =
    "#version 3.7; global_settings { assumed_gamma 1.0 }\n"
    "#declare Used = BandRows + BandBegin + BandEnd;\n"
    "camera { location 0 } background { rgb 1 }\n";

TEST(PovBandsTest, BandsCoverTheRowsOnce) {
  // 960 * 64 = 61440 rays a row: 32 rows make 1.97 million.
  const std::vector<RowBand> bands = BandsOf({960, 640, 64, 0, {}});
  ASSERT_EQ(bands.size(), 20u);
  int row = 0;
  for (const RowBand& band : bands) {
    EXPECT_EQ(band.begin, row);
    row = band.end;
  }
  EXPECT_EQ(row, 640);
  EXPECT_EQ(bands[0].end, 32);
}

TEST(PovBandsTest, ARowIsTheLeast) {
  // 100000 * 64 = 6.4 million rays a row.
  EXPECT_EQ(BandsOf({100000, 3, 64, 0, {}}).size(), 3u);
}

TEST(PovBandsTest, AFinishedBandIsNotRenderedAgain) {
  if (!FindProgram("povray")) GTEST_SKIP() << "povray is not installed";
  const auto folder = FolderWith(kWhite);
  const BandRenderer renderer(folder, {4, 4, 4, 0, {}}, 2);
  const Result<double> first = renderer.Render({0, 2});
  ASSERT_TRUE(first.has_value()) << first.error().ToString();
  // Without its scene POV-Ray could not render anything.
  std::filesystem::remove(folder / "scene.pov");
  const Result<double> again = renderer.Render({0, 2});
  ASSERT_TRUE(again.has_value());
  EXPECT_EQ(*again, *first);
  EXPECT_FALSE(renderer.Render({2, 4}).has_value());
  const Result<Image> mean = renderer.Averaged({0, 2});
  ASSERT_TRUE(mean.has_value());
  EXPECT_EQ(mean->width(), 4);
  EXPECT_EQ(mean->height(), 2);
  EXPECT_EQ(mean->at(3, 1), Rgb(1));
}

TEST(PovBandsTest, ABrokenBandIsRemovedAndSaid) {
  const auto folder = FolderWith("");
  ASSERT_TRUE(WriteFileAtomically(folder / "rows_0_2.exr", "no image"));
  const BandRenderer renderer(folder, {4, 4, 4, 0, {}}, 2);
  EXPECT_FALSE(renderer.Averaged({0, 2}).has_value());
  EXPECT_FALSE(std::filesystem::exists(folder / "rows_0_2.exr"));
}

TEST(PovBandsTest, TellsWhatPovRaySaid) {
  if (!FindProgram("povray")) GTEST_SKIP() << "povray is not installed";
  const BandRenderer renderer(FolderWith("sphere { nonsense"), {4, 4, 4, 0, {}},
                              2);
  const Result<double> done = renderer.Render({0, 2});
  ASSERT_FALSE(done.has_value());
  EXPECT_EQ(done.error().kind, ErrorKind::kFailure);
  EXPECT_THAT(done.error().what, HasSubstr("nonsense"));
}

}  // namespace
}  // namespace rtb
