#include "harness/measure/frame_steps.h"

#include <gtest/gtest.h>

namespace rtb {
namespace {

Image Flat(float value) {
  Image image(16, 16);
  for (Rgb& pixel : image.pixels()) pixel = Rgb(value);
  return image;
}

Frame MakeFrame(float drawn, float reference) {
  return {CellGrid({2, 1}), Flat(drawn), Flat(reference)};
}

// T rises by 3/8, R by 1/8: wrong by 1/4. One that rises too little by as much
// is as wrong.
TEST(FrameStepsTest, TemporalDifferenceError) {
  const Frame before = MakeFrame(0.125f, 0.25f);
  EXPECT_DOUBLE_EQ(TemporalDifferenceError(MakeFrame(0.5f, 0.375f), before, 1),
                   0.25);
  EXPECT_DOUBLE_EQ(TemporalDifferenceError(MakeFrame(0.0f, 0.375f), before, 1),
                   0.25);
  // A constant error of the picture is none of its movement.
  EXPECT_DOUBLE_EQ(TemporalDifferenceError(MakeFrame(0.25f, 0.375f), before, 1),
                   0);
}

TEST(FrameStepsTest, TemporalFlipIsZeroForTheSameStep) {
  const Frame before = MakeFrame(0.25f, 0.25f);
  EXPECT_EQ(TemporalFlip(MakeFrame(0.5f, 0.5f), before, 1), 0);
  const double flickers = TemporalFlip(MakeFrame(0.5f, 0.25f), before, 1);
  EXPECT_GT(flickers, 0.1);
  // The reference's step is the drawn one here, and the drawn one none.
  EXPECT_DOUBLE_EQ(TemporalFlip(MakeFrame(0.25f, 0.5f), before, 1), flickers);
}

TEST(FrameStepsTest, ChangedCellsCountsWhatShows) {
  CellGrid a({4, 1});
  CellGrid b = a;
  EXPECT_EQ(ChangedCells(a, b), 0);
  b.at(0, 0).glyph = U'▄';
  b.at(1, 0).bg = {1, 0, 0};
  b.at(2, 0).fg = {1, 0, 0};  // A space shows no foreground.
  EXPECT_EQ(ChangedCells(a, b), 0.5);
}

TEST(FrameStepsTest, RmsDifference) {
  EXPECT_DOUBLE_EQ(RmsDifference(Flat(0.25f), Flat(0.75f), 1), 0.5);
}

}  // namespace
}  // namespace rtb
