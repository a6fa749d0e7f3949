#include "harness/live/quality_meter.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "core/base/check.h"
#include "harness/live/frame_maker.h"
#include "harness/live/progressive_image.h"

namespace rtb {
namespace {

LiveView ViewOf(const std::string& encoder) {
  LiveView view;
  view.scene = std::string(RTB_TEST_SOURCE_DIR) + "/scenes/whitted.yaml";
  view.encoders = {encoder, encoder};
  view.grid = {12, 5};
  return view;
}

CellGrid PictureOf(const LiveView& view) {
  FrameMaker maker;
  auto frame = maker.Make({view, {}});
  RTB_CHECK(frame.has_value());
  return frame->picture;
}

/// The figures once the converged picture has that many rays.
LiveQuality Judged(const LiveView& view, const CellGrid& picture) {
  QualityMeter meter;
  EXPECT_FALSE(meter.latest().has_value());
  meter.Show(view, picture);
  while (!meter.latest() || meter.latest()->passes < QualityMeter::kMostRays) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  const LiveQuality quality = *meter.latest();
  meter.Forget();
  EXPECT_FALSE(meter.latest().has_value());
  return quality;
}

TEST(QualityMeter, FinerCellsAreNearerToTheConvergedPicture) {
  const LiveView half = ViewOf("half");
  const LiveView optimal = ViewOf("optimal");
  const LiveQuality coarse = Judged(half, PictureOf(half));
  const LiveQuality fine = Judged(optimal, PictureOf(optimal));
  EXPECT_GT(fine.mse, 0);
  EXPECT_LT(fine.mse, coarse.mse);
  EXPECT_LT(fine.flip, coarse.flip);
  EXPECT_EQ(fine.passes, QualityMeter::kMostRays);
}

TEST(ProgressiveImage, BeginsAnewForAnotherView) {
  ProgressiveImage image;
  LiveView view = ViewOf("half");
  ASSERT_TRUE(image.Aim(view));
  ASSERT_TRUE(image.Step(4));
  ASSERT_TRUE(image.Step(4));
  EXPECT_EQ(image.rays(), 8);
  view.encoders[0] = "tiv";  // Does not matter.
  ASSERT_TRUE(image.Aim(view));
  EXPECT_EQ(image.rays(), 8);
  EXPECT_EQ(image.Displayed().width(), 12 * 8);
  view.exposure = 1;
  ASSERT_TRUE(image.Aim(view));
  EXPECT_EQ(image.rays(), 0);
  view.scene = "no/such/scene.yaml";
  EXPECT_FALSE(image.Aim(view));
}

}  // namespace
}  // namespace rtb
