#include "harness/image_source.h"

#include <gtest/gtest.h>

namespace rtb {
namespace {

/// Every pixel differs from every other, with values that floats cannot
/// average by chance.
Image Distinct(int width, int height) {
  Image image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const auto value = static_cast<float>(y * width + x);
      image.at(x, y) = Rgb(value / 7.0f, value / 11.0f, value / 13.0f);
    }
  }
  return image;
}

Image Uniform(int width, int height, float value) {
  Image image(width, height);
  for (Rgb& pixel : image.pixels()) pixel = Rgb(value);
  return image;
}

struct Tiling {
  int nx, ny;
};
void PrintTo(const Tiling& tiling, std::ostream* out) {
  *out << tiling.nx << "x" << tiling.ny;
}

class ExactSize : public ::testing::TestWithParam<Tiling> {};

// 1/3, 1/5 and 1/7 are no floats, so that positions and footprints are
// rounded; the pixels must come out bit for bit nevertheless. The image's
// aspect is far from the grid's, so that any fit but pixel by pixel shows.
TEST_P(ExactSize, GivesEachSampleItsPixelWhateverTheFit) {
  const auto [nx, ny] = GetParam();
  const GridSize grid{53, 7};
  const Image image = Distinct(grid.columns * nx, grid.rows * ny);
  const SamplePlan plan = RegularPlan(grid, nx, ny);
  for (const Fit fit : {Fit::kContain, Fit::kStretch, Fit::kCover}) {
    ImageSource source(image, fit, 1);
    const Fragments fragments = source.Query(plan).value();
    for (int cell = 0; cell < grid.cells(); ++cell) {
      for (int i = 0; i < nx * ny; ++i) {
        const int x = cell % grid.columns * nx + i % nx;
        const int y = cell / grid.columns * ny + i / nx;
        ASSERT_EQ(fragments.cell(cell)[static_cast<std::size_t>(i)],
                  image.at(x, y));
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Tilings, ExactSize,
                         ::testing::Values(Tiling{1, 1}, Tiling{1, 2},
                                           Tiling{2, 2}, Tiling{2, 3},
                                           Tiling{4, 8}, Tiling{5, 7},
                                           Tiling{8, 16}));

// 3 x 1 pixels on 2 x 1 samples: each sample covers one and a half pixels.
TEST(ImageSource, AveragesByExactArea) {
  Image image(3, 1);
  image.at(0, 0) = Rgb(3);
  image.at(1, 0) = Rgb(6);
  image.at(2, 0) = Rgb(12);
  ImageSource source(image, Fit::kStretch, 1);
  const Fragments fragments = source.Query(RegularPlan({2, 1}, 1, 1)).value();
  EXPECT_FLOAT_EQ(fragments.values[0].x, (3 + 0.5f * 6) / 1.5f);
  EXPECT_FLOAT_EQ(fragments.values[1].x, (0.5f * 6 + 12) / 1.5f);
}

// A grid of 4 x 1 cells of aspect 1/2 shows a picture of aspect 2. A square
// image of 10 x 10 leaves a black quarter on either side: cells 0 and 3.
TEST(ImageSource, ContainCentersOnBlack) {
  const Image image = Uniform(10, 10, 1);
  ImageSource source(image, Fit::kContain, 1);
  const Fragments fragments = source.Query(RegularPlan({4, 1}, 1, 1)).value();
  EXPECT_EQ(fragments.values[0], Rgb(0));
  EXPECT_EQ(fragments.values[1], Rgb(1));
  EXPECT_EQ(fragments.values[2], Rgb(1));
  EXPECT_EQ(fragments.values[3], Rgb(0));
}

// A picture of aspect 1/2 (1 x 1 cell) and an image twice as wide as high: the
// image fills the width and stands in the middle, a quarter of the height:
// 1 / (2 * 2). Eight sample rows: the third and the sixth are half covered.
TEST(ImageSource, ContainCentersHighPictures) {
  const Image image = Uniform(20, 10, 1);
  ImageSource source(image, Fit::kContain, 1);
  const Fragments fragments = source.Query(RegularPlan({1, 1}, 1, 8)).value();
  const float expected[8] = {0, 0, 0, 1, 1, 0, 0, 0};
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT_FLOAT_EQ(fragments.values[i].x, expected[i]) << i;
  }
}

// The same picture of aspect 2; cover cuts the upper and lower quarter of the
// square image: its rows 2.5 to 7.5 remain. Row y has the value y.
TEST(ImageSource, CoverCutsTheRest) {
  Image image(10, 10);
  for (int y = 0; y < 10; ++y) {
    for (int x = 0; x < 10; ++x) {
      image.at(x, y) = Rgb(static_cast<float>(y));
    }
  }
  ImageSource source(image, Fit::kCover, 1);
  const Fragments fragments = source.Query(RegularPlan({4, 1}, 1, 1)).value();
  // (0.5 * 2 + 3 + 4 + 5 + 6 + 0.5 * 7) / 5
  for (const Rgb& value : fragments.values) EXPECT_FLOAT_EQ(value.x, 4.5f);
}

TEST(ImageSource, DoesNotDependOnThreads) {
  const Image image = Distinct(101, 67);
  const SamplePlan plan = RegularPlan({31, 17}, 3, 5);
  ImageSource one(image, Fit::kCover, 1);
  ImageSource three(image, Fit::kCover, 3);
  EXPECT_EQ(one.Query(plan)->values, three.Query(plan)->values);
}

TEST(ImageSource, RefusesAbsurdPlansBeforeAllocating) {
  const Image image = Uniform(2, 2, 1);
  ImageSource source(image, Fit::kContain, 1);
  SamplePlan plan = RegularPlan({4096, 4096}, 4, 8);  // 2^29 samples
  const auto fragments = source.Query(plan);
  ASSERT_FALSE(fragments.has_value());
  EXPECT_EQ(fragments.error().kind, ErrorKind::kBadInput);
}

TEST(ParseFit, NamesWhatIsPossible) {
  EXPECT_EQ(ParseFit("--fit", "cover").value(), Fit::kCover);
  EXPECT_EQ(ParseFit("--fit", "fill").error().what,
            "found 'fill', expected contain, stretch or cover");
}

}  // namespace
}  // namespace rtb
