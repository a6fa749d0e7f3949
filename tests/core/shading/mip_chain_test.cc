#include "core/shading/mip_chain.h"

#include <gtest/gtest.h>

namespace rtb {
namespace {

HeightMap Counting(int width, int height) {
  HeightMap map{width, height, {}};
  for (int i = 0; i < width * height; ++i) {
    map.values.push_back(static_cast<float>(i));
  }
  return map;
}

// 0 1 2 3   (0 + 1 + 4 + 5) / 4 = 2.5, (2 + 3 + 6 + 7) / 4 = 4.5, and their
// 4 5 6 7   mean 3.5.
TEST(MipChainTest, EachLevelIsTheMeanOfFour) {
  const MipChain<float> chain = MakeMipChain(Counting(4, 2));
  EXPECT_EQ(chain.levels, 3);
  const TexelGrid<float> half = LevelOf(chain.grid(), 1);
  EXPECT_EQ(half.width, 2);
  EXPECT_EQ(half.height, 1);
  EXPECT_EQ(half.at(0, 0), 2.5f);
  EXPECT_EQ(half.at(1, 0), 4.5f);
  const TexelGrid<float> mean = LevelOf(chain.grid(), 2);
  EXPECT_EQ(mean.width, 1);
  EXPECT_EQ(mean.height, 1);
  EXPECT_EQ(mean.at(0, 0), 3.5f);
  EXPECT_EQ(TexelsOfAllLevels(chain.grid()), chain.texels.size());
  EXPECT_EQ(chain.texels.size(), 8u + 2 + 1);
}

// Sizes that are no powers of two: 7 x 5, 3 x 2, 1 x 1, by areas: all means
// are that of 0 .. 34.
TEST(MipChainTest, OddSizesKeepTheMean) {
  const MipChain<float> chain = MakeMipChain(Counting(7, 5));
  EXPECT_EQ(chain.levels, 3);
  for (int level = 0; level < 3; ++level) {
    const TexelGrid<float> grid = LevelOf(chain.grid(), level);
    float sum = 0;
    for (int y = 0; y < grid.height; ++y) {
      for (int x = 0; x < grid.width; ++x) sum += grid.at(x, y);
    }
    EXPECT_NEAR(sum / static_cast<float>(grid.width * grid.height), 17, 1e-4f)
        << level;
  }
}

TEST(MipChainTest, ColorsAreAveragedApart) {
  Image image(2, 1);
  image.at(0, 0) = Rgb(1, 0, 0.5f);
  image.at(1, 0) = Rgb(0, 0.5f, 0.5f);
  const MipChain<Rgb> chain = MakeMipChain(image);
  EXPECT_EQ(LevelOf(chain.grid(), 1).at(0, 0), Rgb(0.5f, 0.25f, 0.5f));
}

}  // namespace
}  // namespace rtb
