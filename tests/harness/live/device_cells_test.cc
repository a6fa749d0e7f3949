// The live mode lets a device choose cells where it can: here a double of it,
// which renders and encodes on the CPU and counts what is asked of it.
#include "harness/live/device_cells.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "encoders/registry.h"
#include "harness/live/frame_maker.h"
#include "tests/encoders/given_source.h"

namespace rtb {
namespace {

/// What was asked of the doubles.
struct Log {
  int sample_frames = 0;  ///< Whose samples came to the host.
  int cell_frames = 0;    ///< Whose cells did.
};

class BackendDouble : public AheadBackend {
 public:
  BackendDouble(std::unique_ptr<Backend> inner, Log* log)
      : inner_(std::move(inner)), log_(log) {}

  std::string name() const override { return "double"; }
  RayCounts ray_counts() const override { return inner_->ray_counts(); }
  Result<Fragments> Render(const SamplePlan& plan,
                           const RenderOptions& options) override {
    ++log_->sample_frames;
    return inner_->Render(plan, options);
  }
  Status Submit(const SamplePlan& plan, const RenderOptions& options,
                DeviceStage* /*stage*/) override {
    ++log_->cell_frames;
    frame_ = inner_->Render(plan, options);
    return {};
  }
  Result<Fragments> Collect() override { return std::move(frame_); }

 private:
  std::unique_ptr<Backend> inner_;
  Log* log_;
  Result<Fragments> frame_;
};

/// Encoder quadrant of a device.
class QuadrantDouble : public DeviceEncoder {
 public:
  SamplePlan Plan(GridSize grid, double cell_aspect) const override {
    return RegularPlan(grid, 2, 2, cell_aspect);
  }
  Status Submit(AheadBackend& backend, const SamplePlan& plan,
                const RenderOptions& options, double exposure) override {
    gain_ = static_cast<float>(std::exp2(exposure));
    grid_ = plan.grid;
    return backend.Submit(plan, options, nullptr);
  }
  Result<CellGrid> Collect(AheadBackend& backend) override {
    RTB_ASSIGN_OR_RETURN(Fragments fragments, backend.Collect());
    for (Rgb& value : fragments.values) value *= gain_;
    GivenSource source(std::move(fragments.values));
    const auto encoder = MakeEncoder("quadrant").value();
    RTB_ASSIGN_OR_RETURN(const Encoding encoding,
                         encoder->Run(source, grid_, 0.5, {}));
    return encoding.grid;
  }

 private:
  float gain_ = 1;
  GridSize grid_;
};

Result<std::unique_ptr<DeviceEncoder>> MakeDouble(const std::string& name) {
  if (name == "quadrant") return std::make_unique<QuadrantDouble>();
  return Fail(BadInput("--encoder", "not on the device"));
}

FrameParts WithDoubles(Log* log) {
  FrameParts parts;
  parts.prepare = [log](const SceneRequest& request) -> Result<PreparedScene> {
    RTB_ASSIGN_OR_RETURN(PreparedScene prepared, PrepareScene(request));
    prepared.backend =
        std::make_unique<BackendDouble>(std::move(prepared.backend), log);
    return prepared;
  };
  parts.device_encoder = MakeDouble;
  return parts;
}

LiveView QuadrantView() {
  LiveView view;
  view.scene = std::string(RTB_TEST_SOURCE_DIR) + "/scenes/whitted.yaml";
  view.encoders = {"quadrant", "quadrant"};
  view.grid = {24, 10};
  view.exposure = -0.5;
  return view;
}

class DeviceCellsTest : public ::testing::Test {
 protected:
  LiveFrame Make(const LiveView& view, const RayBudget& budget = {}) {
    auto frame = maker_.Make({view, budget});
    RTB_CHECK(frame.has_value());
    return std::move(*frame);
  }

  Log log_;
  FrameMaker maker_{WithDoubles(&log_)};
};

TEST_F(DeviceCellsTest, APictureThatMovesComesAsCells) {
  FrameMaker from_samples;
  LiveView view = QuadrantView();
  for (const double time : {0.0, 0.2, 0.4}) {
    view.time = time;
    const LiveFrame got = Make(view);
    const auto expected = from_samples.Make({view, {}});
    ASSERT_TRUE(expected.has_value());
    EXPECT_EQ(got.picture, expected->picture);
    EXPECT_EQ(got.rays, expected->rays);
    EXPECT_EQ(got.rays_per_cell, expected->rays_per_cell);
    EXPECT_EQ(got.samples_per_cell, 4);
    EXPECT_EQ(got.passes, 1);
  }
  EXPECT_EQ(log_.cell_frames, 3);
  EXPECT_EQ(log_.sample_frames, 0);
}

TEST_F(DeviceCellsTest, APictureAtRestGathersSamples) {
  const LiveView view = QuadrantView();
  const CellGrid first = Make(view).picture;
  // The store's first pass is the device's picture again.
  EXPECT_EQ(Make(view).picture, first);
  EXPECT_EQ(Make(view).passes, 2);
  EXPECT_EQ(log_.cell_frames, 1);
  EXPECT_EQ(log_.sample_frames, 2);
}

TEST_F(DeviceCellsTest, WhatNeedsSamplesGetsThem) {
  std::vector<std::pair<LiveView, RayBudget>> requests(
      7, {QuadrantView(), RayBudget{}});
  for (std::size_t i = 0; i < requests.size(); ++i) {
    requests[i].first.time = static_cast<double>(i);
  }
  requests[0].first.encoders[0] = "quadrant:blend=linear";
  requests[1].first.encoders[0] = "octant";
  requests[2].first.depth = ColorDepth::k256;
  requests[3].first.split = true;
  requests[3].first.divider = 9;
  requests[4].first.spp = 2;  // noise, which `temporal` judges
  requests[5].second.share = 0.5;
  requests[6].second.row_step = 2;
  for (const auto& [view, budget] : requests) Make(view, budget);
  EXPECT_EQ(log_.cell_frames, 0);
  EXPECT_GE(log_.sample_frames, 7);
}

TEST_F(DeviceCellsTest, NoiseThatNothingJudgesMayComeAsCells) {
  LiveView view = QuadrantView();
  view.spp = 2;
  view.temporal = false;
  Make(view, {.spp = 2, .share = 1, .row_step = 1});
  EXPECT_EQ(log_.cell_frames, 1);
}

TEST_F(DeviceCellsTest, ABackendOfTheHostHasNone) {
  DeviceCells cells(MakeDouble);
  SceneRequest scene;
  scene.scene = QuadrantView().scene;
  const auto prepared = PrepareScene(scene);
  ASSERT_TRUE(prepared.has_value());
  DeviceRequest request;
  request.encoder = "quadrant";
  request.grid = {4, 4};
  const auto drawn = cells.Draw(*prepared->backend, request);
  ASSERT_TRUE(drawn.has_value());
  EXPECT_FALSE(drawn->has_value());
}

TEST_F(DeviceCellsTest, ADeviceThatFailsIsAnError) {
  FrameParts parts = WithDoubles(&log_);
  parts.device_encoder = [](const std::string& /*name*/)
      -> Result<std::unique_ptr<DeviceEncoder>> {
    return Fail(Failure("--backend=cuda", "no memory"));
  };
  const auto frame = FrameMaker(parts).Make({QuadrantView(), {}});
  ASSERT_FALSE(frame.has_value());
  EXPECT_EQ(frame.error().what, "no memory");
  EXPECT_EQ(log_.sample_frames, 0);
}

}  // namespace
}  // namespace rtb
