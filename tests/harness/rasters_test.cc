#include "harness/rasters.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/color/srgb.h"
#include "core/image/io.h"
#include "tests/harness/temporary_folder.h"

namespace rtb {
namespace {

using ::testing::HasSubstr;

/// Columns of black and white, one pixel each.
Image Stripes(int width, int height) {
  Image image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      image.at(x, y) = Rgb(static_cast<float>(x % 2));
    }
  }
  return image;
}

TEST(MatchRasters, EqualSizesStayAsTheyAre) {
  const Image stripes = Stripes(4, 2);
  const RasterPair pair = MatchRasters(stripes, stripes, "--reference").value();
  for (std::size_t i = 0; i < stripes.pixels().size(); ++i) {
    EXPECT_EQ(pair.reference.pixels()[i], stripes.pixels()[i]);
    EXPECT_EQ(pair.test.pixels()[i], stripes.pixels()[i]);
  }
}

// Black and white average to half the light, which is 0.7354 encoded:
// 1.055 * 0.5^(1/2.4) - 0.055. Averaging encoded values would give 0.5.
TEST(MatchRasters, ReducesTheLargerInLinearLight) {
  const Image large = Stripes(8, 4);
  const Image small(4, 2);
  const RasterPair a = MatchRasters(large, small, "--reference").value();
  EXPECT_EQ(a.reference.width(), 4);
  EXPECT_EQ(a.reference.height(), 2);
  EXPECT_NEAR(a.reference.at(0, 0).x, 0.735357f, 1e-5f);
  EXPECT_EQ(a.reference_size, (PixelSize{8, 4}));
  EXPECT_EQ(a.test_size, (PixelSize{4, 2}));
  const RasterPair b = MatchRasters(small, large, "--reference").value();
  EXPECT_EQ(b.test.width(), 4);
  EXPECT_NEAR(b.test.at(3, 1).x, 0.735357f, 1e-5f);
}

// 1333 and 1334 rows of 2000 differ by 0.075 %: one picture, of which neither
// side may be enlarged.
TEST(MatchRasters, NeverEnlargesASide) {
  const Image low(2000, 1333);
  const Image high(2000, 1334);
  const auto matched = [](const Image& reference, const Image& test) {
    const RasterPair pair =
        MatchRasters(reference, test, "--reference").value();
    EXPECT_EQ(pair.reference.width(), pair.test.width());
    EXPECT_EQ(pair.reference.height(), pair.test.height());
    return PixelSize{pair.test.width(), pair.test.height()};
  };
  EXPECT_EQ(matched(low, high), (PixelSize{2000, 1333}));
  EXPECT_EQ(matched(high, low), (PixelSize{2000, 1333}));
}

TEST(MatchRasters, RefusesAnotherAspect) {
  const auto pair =
      MatchRasters(Image(960, 640), Image(960, 642), "--reference");
  ASSERT_FALSE(pair.has_value());
  EXPECT_EQ(pair.error().kind, ErrorKind::kBadInput);
  EXPECT_EQ(pair.error().place, "--reference");
  EXPECT_THAT(pair.error().what, HasSubstr("960x640"));
  // 1.5 against 2001 / 1333 = 1.50113: 0.075 %.
  EXPECT_TRUE(CheckAspects({960, 640}, {2001, 1333}, "").has_value());
}

// 0.25 exposed by one stop is 0.5: 0.735357 encoded, code 188 (187.516).
TEST(ReadDisplayed, ExposesLinearFilesAndRounds) {
  const TemporaryFolder folder;
  Image gray(2, 2);
  for (Rgb& pixel : gray.pixels()) pixel = Rgb(0.25f);
  ASSERT_TRUE(WriteExr(folder.path() / "a.exr", gray, ExrType::kFloat));
  const auto exr = ReadDisplayed(folder.path() / "a.exr", 1);
  EXPECT_EQ(exr->at(0, 0), Rgb(188.0f / 255.0f));
}

// What a PNG holds has been displayed once: exposing it again would be wrong.
TEST(ReadDisplayed, LeavesDisplayFilesAsTheyAre) {
  const TemporaryFolder folder;
  Image gray(2, 2);
  for (Rgb& pixel : gray.pixels()) pixel = Rgb(77.0f / 255.0f);
  ASSERT_TRUE(WritePng(folder.path() / "a.png", gray));
  EXPECT_EQ(ReadDisplayed(folder.path() / "a.png", 1)->at(1, 1),
            Rgb(77.0f / 255.0f));
}

}  // namespace
}  // namespace rtb
