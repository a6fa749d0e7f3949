#include "harness/measure/temporal.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "encoders/emit/emit.h"
#include "tests/harness/temporary_folder.h"

namespace rtb {
namespace {

using testing::HasSubstr;

constexpr char kStill[] =
    "rtbench_scene: 1\n"
    "name: sky\n"
    "camera: {position: [0, 0, 0], look_at: [0, 0, -1], vfov: 40}\n"
    "background: {type: constant, color: [0.25, 0.5, 0]}\n";

/// A ball that crosses the picture in one second.
constexpr char kMoving[] =
    "materials: [{id: m, type: emissive, radiance: [1, 1, 1]}]\n"
    "objects: [{type: sphere, center: [-2, 0, -4], radius: 0.7, material: m, "
    "path: p}]\n"
    "paths: [{id: p, points: [[0, 0, 0], [4, 0, 0]], duration: 1}]\n";

class TemporalTest : public testing::Test {
 protected:
  Result<TemporalResult> Measure(const std::string& spec,
                                 const std::string& scene, int spp = 1) {
    SceneRequest request;
    request.scene = folder_.Write("scene.yaml", scene).string();
    request.options.spp = spp;
    const PreparedScene prepared = std::move(PrepareScene(request).value());
    TemporalRequest temporal{prepared, spec, {6, 2}, {}, {}};
    temporal.frames = frames_;
    temporal.cache = folder_.path() / "cache";
    return MeasureTemporal(temporal, [this](double share, const std::string&) {
      EXPECT_GT(share, share_);
      share_ = share;
    });
  }

  TemporaryFolder folder_;
  int frames_ = kLeastFrames;
  double share_ = 0;
};

TEST_F(TemporalTest, AStillPictureIsSteady) {
  const TemporalResult result = Measure("half", kStill).value();
  EXPECT_EQ(result.frames, kLeastFrames);
  EXPECT_EQ(result.fps, 24);
  EXPECT_EQ(result.tde, 0);
  EXPECT_EQ(result.t_flip, 0);
  EXPECT_EQ(result.warp_error, 0);
  EXPECT_EQ(result.churn, 0);
  EXPECT_EQ(result.static_flicker, 0);
  EXPECT_EQ(result.static_flicker_rms, 0);
  // Linear 0.25, 0.5 and 0 are the codes 137, 188 and 0.
  CellGrid grid({6, 2});
  for (Cell& cell : grid.cells) {
    cell = {U'▄', {137, 188, 0}, {137, 188, 0}};
  }
  EXPECT_NEAR(result.bytes_per_frame,
              static_cast<double>(EmitAnsi(grid).size()), 1e-9);
  EXPECT_EQ(share_, 1);
}

// The ball's edge passes from cell to cell: the grid jumps where the reference
// glides.
TEST_F(TemporalTest, AMovingPictureIsNot) {
  const std::string scene = std::string(kStill) + kMoving;
  const TemporalResult result = Measure("half", scene).value();
  EXPECT_GT(result.tde, 0.001);
  EXPECT_GT(result.t_flip, 0.001);
  EXPECT_GT(result.warp_error.value(), 0);
  EXPECT_GT(result.churn, 0);
  EXPECT_LT(result.churn, 0.5);
  // One ray at each pixel's center takes no random number.
  EXPECT_EQ(result.static_flicker, 0);
}

// Two rays a sample are placed at random: the cells at the ball's edge change
// with the seed, unless the encoder may keep what noise explains.
TEST_F(TemporalTest, FlickersWithTheSeed) {
  const std::string still_ball =
      std::string(kStill) +
      "materials: [{id: m, type: emissive, radiance: [1, 1, 1]}]\n"
      "objects: [{type: sphere, center: [0.1, 0, -4], radius: 0.7, material: "
      "m}]\n";
  const TemporalResult free = Measure("half", still_ball, 2).value();
  EXPECT_GT(free.static_flicker, 0);
  EXPECT_GT(free.static_flicker_rms, 0);
  EXPECT_EQ(free.churn, 0);  // Every frame has the same seed.
  share_ = 0;
  const TemporalResult kept = Measure("half:temporal=3", still_ball, 2).value();
  EXPECT_LT(kept.static_flicker, free.static_flicker);
}

TEST_F(TemporalTest, RefusesWhatCannotBeMeasured) {
  frames_ = kLeastFrames - 1;
  const auto few = Measure("half", kStill);
  ASSERT_FALSE(few.has_value());
  EXPECT_THAT(few.error().what, HasSubstr("at least 24"));
  frames_ = kLeastFrames;
  EXPECT_FALSE(Measure("thirds", kStill).has_value());
}

}  // namespace
}  // namespace rtb
