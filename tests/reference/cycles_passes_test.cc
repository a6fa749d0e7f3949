#include "reference/cycles_passes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rtb {
namespace {

ReferenceRequest Request(int spp) {
  ReferenceRequest request;
  request.spp = spp;
  request.seed = 7;
  return request;
}

TEST(CyclesPassesTest, PassesContinueOneSequence) {
  const auto passes = PassesOf(Request(150));
  ASSERT_EQ(passes.size(), 3u);
  EXPECT_EQ(passes[0].first, 0);
  EXPECT_EQ(passes[1].first, 64);
  EXPECT_EQ(passes[2].first, 128);
  EXPECT_EQ(passes[1].spp, 64);
  EXPECT_EQ(passes[2].spp, 22);
}

TEST(CyclesPassesTest, TheCommandNamesTheSamples) {
  const CyclesPassRenderer renderer("work", Request(150));
  const auto command = renderer.Command({2, 22, 128});
  EXPECT_EQ(command.front(), "blender");
  EXPECT_THAT(command,
              testing::IsSupersetOf({"--output=pass_2_22.exr", "--width=960",
                                     "--height=640", "--spp=22", "--first=128",
                                     "--seed=7"}));
}

TEST(CyclesPassesTest, TheMeanWeighsPassesBySamples) {
  Image one(2, 1), two(2, 1);
  one.at(0, 0) = Rgb(1, 2, 3);
  two.at(0, 0) = Rgb(5, 2, 7);
  ImageMean mean(2, 1);
  mean.Add(one, 3);
  mean.Add(two, 1);
  // (3 * 1 + 5) / 4, 2, (3 * 3 + 7) / 4
  EXPECT_EQ(mean.Take().at(0, 0), Rgb(2, 2, 4));
  EXPECT_EQ(mean.Take().at(1, 0), Rgb(0));
}

}  // namespace
}  // namespace rtb
