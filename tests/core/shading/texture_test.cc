#include "core/shading/texture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "core/image/image.h"
#include "core/shading/mip_chain.h"
#include "core/shading/texture_load.h"

namespace rtb {
namespace {

const Rgb kRed(1, 0, 0);
const Rgb kGreen(0, 1, 0);
const Rgb kBlue(0, 0, 1);
const Rgb kWhite(1);

/// red green
/// blue white
Image FourColors() {
  Image image(2, 2);
  image.at(0, 0) = kRed;
  image.at(1, 0) = kGreen;
  image.at(0, 1) = kBlue;
  image.at(1, 1) = kWhite;
  return image;
}

TEST(TextureTest, UToTheRightVUpwards) {
  const MipChain<Rgb> image = MakeMipChain(FourColors());
  const ImageTextureData texture = TextureOf(image, V2f(1));
  EXPECT_EQ(TextureColor(texture, V2f(0.25f, 0.25f)), kBlue);
  EXPECT_EQ(TextureColor(texture, V2f(0.75f, 0.25f)), kWhite);
  EXPECT_EQ(TextureColor(texture, V2f(0.25f, 0.75f)), kRed);
  EXPECT_EQ(TextureColor(texture, V2f(0.75f, 0.75f)), kGreen);
}

// Centers are 1/2 apart: between them the mean, in the middle that of all.
TEST(TextureTest, InterpolatesBetweenCenters) {
  const MipChain<Rgb> image = MakeMipChain(FourColors());
  const ImageTextureData texture = TextureOf(image, V2f(1));
  EXPECT_EQ(TextureColor(texture, V2f(0.5f, 0.75f)), (kRed + kGreen) / 2);
  EXPECT_EQ(TextureColor(texture, V2f(0.25f, 0.5f)), (kRed + kBlue) / 2);
  EXPECT_EQ(TextureColor(texture, V2f(0.5f)), Rgb(0.5f));
  // A quarter of the way from blue to white.
  EXPECT_EQ(TextureColor(texture, V2f(0.375f, 0.25f)),
            kBlue * 0.75f + kWhite * 0.25f);
}

// Past the edges the other side comes: at u = 0 the mean of both columns.
TEST(TextureTest, WrapsInBothDirections) {
  const MipChain<Rgb> image = MakeMipChain(FourColors());
  const ImageTextureData texture = TextureOf(image, V2f(1));
  EXPECT_EQ(TextureColor(texture, V2f(0, 0.75f)), (kRed + kGreen) / 2);
  EXPECT_EQ(TextureColor(texture, V2f(1, 0.75f)), (kRed + kGreen) / 2);
  EXPECT_EQ(TextureColor(texture, V2f(0.25f, 0)), (kRed + kBlue) / 2);
  EXPECT_EQ(TextureColor(texture, V2f(0.25f, 1)), (kRed + kBlue) / 2);
  for (const float turn : {-7.0f, -1.0f, 1.0f, 5.0f}) {
    EXPECT_EQ(TextureColor(texture, V2f(0.25f + turn, 0.75f)), kRed);
    EXPECT_EQ(TextureColor(texture, V2f(0.25f, 0.75f + turn)), kRed);
  }
}

TEST(TextureTest, ScaleMultipliesTheCoordinates) {
  const MipChain<Rgb> image = MakeMipChain(FourColors());
  const ImageTextureData texture = TextureOf(image, V2f(4, 2));
  EXPECT_EQ(TextureColor(texture, V2f(0.25f / 4, 0.75f / 2)), kRed);
  EXPECT_EQ(TextureColor(texture, V2f(1.75f / 4, 0.25f / 2)), kWhite);
}

TEST(TextureTest, AnyCoordinatesStayInTheImage) {
  const MipChain<Rgb> image = MakeMipChain(FourColors());
  const ImageTextureData texture = TextureOf(image, V2f(1));
  for (const float u : {-1e-9f, 1e30f, -1e30f, 16777217.0f,
                        std::numeric_limits<float>::infinity(),
                        std::numeric_limits<float>::quiet_NaN()}) {
    const Rgb color = TextureColor(texture, V2f(u, -u));
    EXPECT_TRUE(color.x >= 0 && color.x <= 1) << u;
  }
}

TEST(TextureTest, OneTexelIsTheSameEverywhere) {
  Image image(1, 1);
  image.at(0, 0) = Rgb(0.25f, 0.5f, 1);
  const MipChain<Rgb> levels = MakeMipChain(image);
  const ImageTextureData texture = TextureOf(levels, V2f(3));
  for (const float u : {0.0f, 0.3f, 0.5f, 0.99f, -4.7f}) {
    EXPECT_EQ(TextureColor(texture, V2f(u, 1 - u)), Rgb(0.25f, 0.5f, 1));
  }
}

/// 256 x 256 texels; red is the squared distance of a texel's center from the
/// middle column, in units of the image's width, green from the middle row.
MipChain<Rgb> SquaredDistances() {
  Image image(256, 256);
  for (int y = 0; y < 256; ++y) {
    for (int x = 0; x < 256; ++x) {
      const float u = (static_cast<float>(x) + 0.5f) / 256 - 0.5f;
      const float v = (static_cast<float>(y) + 0.5f) / 256 - 0.5f;
      image.at(x, y) = Rgb(u * u, v * v, 0);
    }
  }
  return MakeMipChain(image);
}

/// The variances, in squared texels, of the weights that a footprint gives to
/// texels: where the texture is u^2, it shows u^2 and them. Interpolation errs
/// by the place between texels, so many places are looked at.
V2f VariancesOf(const UvFootprint& footprint) {
  const MipChain<Rgb> image = SquaredDistances();
  const ImageTextureData texture = TextureOf(image, V2f(1));
  constexpr int kPlaces = 64;
  V2f sum(0);
  for (int i = 0; i < kPlaces; ++i) {
    for (int j = 0; j < kPlaces; ++j) {
      const V2f from(static_cast<float>(i) / kPlaces * 16 / 256,
                     static_cast<float>(j) / kPlaces * 16 / 256);
      const Rgb seen = TextureColor(texture, V2f(0.5f) + from, footprint);
      sum += V2f(seen.x - from.x * from.x, seen.y - from.y * from.y);
    }
  }
  return sum / (kPlaces * kPlaces) * (256 * 256);
}

// A box of width w has a variance of w^2 / 12; a square footprint is looked up
// once, between levels. Linear between levels is at most 13 % above the square
// between them: 1.5 (1 + 4) / 2 ... (1.5)^2 = 2.5 / 2.25.
TEST(TextureTest, FootprintsWeighTexelsAsWideAsTheyAre) {
  for (const float width : {7.0f, 10.0f, 14.0f, 20.0f}) {
    const V2f variances =
        VariancesOf({V2f(width / 256, 0), V2f(0, width / 256)});
    EXPECT_GT(variances.x, width * width / 12 * 0.98f) << width;
    EXPECT_LT(variances.x, width * width / 12 * 1.14f) << width;
    EXPECT_NEAR(variances.y, variances.x, 0.01f * variances.x) << width;
  }
}

// Six times as long as wide: several lookups along it, and none of the blur
// across that one square would need.
TEST(TextureTest, LongFootprintsStayNarrow) {
  const V2f variances = VariancesOf({V2f(7.0f / 256, 0), V2f(0, 42.0f / 256)});
  EXPECT_NEAR(variances.x, 49.0f / 12, 0.15f * 49 / 12);
  EXPECT_NEAR(variances.y, 42.0f * 42 / 12, 0.1f * 42 * 42 / 12);
}

// Turned by 45 degrees both axes share the variance.
TEST(TextureTest, FootprintsMayLieAcross) {
  const float half = std::sqrt(0.5f);
  const V2f variances = VariancesOf(
      {V2f(7 * half, -7 * half) / 256, V2f(28 * half, 28 * half) / 256});
  const float expected = (49 + 28 * 28) / 24.0f;
  EXPECT_NEAR(variances.x, expected, 0.1f * expected);
  EXPECT_NEAR(variances.y, expected, 0.1f * expected);
}

// Finer than a texel is the point; larger than the image, or no number, its
// mean or any color of it, but never anything else.
TEST(TextureTest, FootprintsOfAnySizeGiveColorsOfTheImage) {
  const MipChain<Rgb> image = MakeMipChain(FourColors());
  const ImageTextureData texture = TextureOf(image, V2f(1));
  const V2f uv(0.3f, 0.8f);
  EXPECT_EQ(TextureColor(texture, uv, {V2f(0.3f, 0), V2f(0, 0.3f)}),
            TextureColor(texture, uv));
  const Rgb mean = TextureColor(texture, uv, {V2f(50, 0), V2f(0, 50)});
  EXPECT_LT((mean - Rgb(0.5f)).length(), 1e-5f);
  const float infinity = std::numeric_limits<float>::infinity();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (const float size : {1e18f, 1e30f, infinity, nan}) {
    const Rgb color =
        TextureColor(texture, uv, {V2f(size, 1), V2f(-size, size)});
    EXPECT_TRUE(color.x >= 0 && color.x <= 1) << size;
  }
}

// Bilinear interpolation is exact for a + b x + c y + d x y.
TEST(BilinearTest, ReproducesBilinearFunctions) {
  const auto f = [](float x, float y) { return 3 + 2 * x - y + 0.5f * x * y; };
  std::vector<float> values;
  for (int y = 0; y < 6; ++y) {
    for (int x = 0; x < 5; ++x) {
      values.push_back(
          f(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f));
    }
  }
  const TexelGrid<float> grid{5, 6, values.data()};
  for (float x = 0.5f; x < 4.5f; x += 0.37f) {
    for (float y = 0.5f; y < 5.5f; y += 0.29f) {
      EXPECT_NEAR(Bilinear(grid, x, y, EdgeRule::kWrap), f(x, y), 1e-5);
    }
  }
}

TEST(BilinearTest, ClampsOrWrapsVertically) {
  const float values[] = {1, 5};
  const TexelGrid<float> column{1, 2, values};
  EXPECT_EQ(Bilinear(column, 0.5f, 0, EdgeRule::kClamp), 1);
  EXPECT_EQ(Bilinear(column, 0.5f, 2, EdgeRule::kClamp), 5);
  EXPECT_EQ(Bilinear(column, 0.5f, 0, EdgeRule::kWrap), 3);
  EXPECT_EQ(Bilinear(column, 0.5f, 2, EdgeRule::kWrap), 3);
}

}  // namespace
}  // namespace rtb
