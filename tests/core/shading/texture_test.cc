#include "core/shading/texture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "core/image/image.h"
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
  const Image image = FourColors();
  const ImageTextureData texture = TextureOf(image, V2f(1));
  EXPECT_EQ(TextureColor(texture, V2f(0.25f, 0.25f)), kBlue);
  EXPECT_EQ(TextureColor(texture, V2f(0.75f, 0.25f)), kWhite);
  EXPECT_EQ(TextureColor(texture, V2f(0.25f, 0.75f)), kRed);
  EXPECT_EQ(TextureColor(texture, V2f(0.75f, 0.75f)), kGreen);
}

// Centers are 1/2 apart: between them the mean, in the middle that of all.
TEST(TextureTest, InterpolatesBetweenCenters) {
  const Image image = FourColors();
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
  const Image image = FourColors();
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
  const Image image = FourColors();
  const ImageTextureData texture = TextureOf(image, V2f(4, 2));
  EXPECT_EQ(TextureColor(texture, V2f(0.25f / 4, 0.75f / 2)), kRed);
  EXPECT_EQ(TextureColor(texture, V2f(1.75f / 4, 0.25f / 2)), kWhite);
}

TEST(TextureTest, AnyCoordinatesStayInTheImage) {
  const Image image = FourColors();
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
  const ImageTextureData texture = TextureOf(image, V2f(3));
  for (const float u : {0.0f, 0.3f, 0.5f, 0.99f, -4.7f}) {
    EXPECT_EQ(TextureColor(texture, V2f(u, 1 - u)), Rgb(0.25f, 0.5f, 1));
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
