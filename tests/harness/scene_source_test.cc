#include "harness/scene_source.h"

#include <gtest/gtest.h>

#include "encoders/plan_encoder.h"
#include "harness/prepared_scene.h"
#include "harness/run_encoder.h"

namespace rtb {
namespace {

/// Renders cell c, sample s as radiance 100 c + s, whatever the scene.
class CountingBackend : public Backend {
 public:
  std::string name() const override { return "counting"; }

  Result<Fragments> Render(const SamplePlan& plan,
                           const RenderOptions& options) override {
    ++calls;
    last = options;
    Fragments fragments(plan);
    for (int cell = 0; cell < plan.grid.cells(); ++cell) {
      for (int i = 0; i < plan.samples_per_cell; ++i) {
        fragments.cell(cell)[static_cast<std::size_t>(i)] =
            Rgb(static_cast<float>(100 * cell + i));
      }
    }
    return fragments;
  }

  RayCounts ray_counts() const override { return {}; }

  int calls = 0;
  RenderOptions last;
};

TEST(SceneSource, MultipliesByTwoToTheExposure) {
  CountingBackend backend;
  RenderOptions options;
  options.spp = 4;
  SceneSource source(backend, options, -1);
  const Fragments fragments = source.Query(RegularPlan({2, 1}, 2, 1)).value();
  EXPECT_EQ(fragments.values[1], Rgb(0.5f));
  EXPECT_EQ(fragments.values[2], Rgb(50.0f));
  EXPECT_EQ(backend.last.spp, 4);
}

TEST(SceneSource, RefusesAbsurdPlansBeforeRendering) {
  CountingBackend backend;
  SceneSource source(backend, {}, 0);
  EXPECT_FALSE(source.Query(RegularPlan({4096, 4096}, 4, 8)).has_value());
  EXPECT_EQ(backend.calls, 0);
}

TEST(RenderImage, PutsPixelsRowByRow) {
  CountingBackend backend;
  const Image image = RenderImage(backend, {3, 2}, {}).value();
  EXPECT_EQ(image.at(2, 0), Rgb(200.0f));
  EXPECT_EQ(image.at(0, 1), Rgb(300.0f));
}

/// Plans `samples` a cell and draws nothing.
class IdleEncoder : public PlanEncoder {
 public:
  explicit IdleEncoder(int samples) : samples_(samples) {}
  SamplePlan Plan(GridSize grid, double aspect,
                  std::uint64_t /*seed*/) const override {
    return RegularPlan(grid, samples_, 1, aspect);
  }
  Result<CellGrid> Encode(const Fragments& fragments,
                          const EncodeContext& /*context*/) const override {
    return CellGrid(fragments.grid);
  }

 private:
  int samples_;
};

TEST(RunEncoder, TimesBothHalves) {
  CountingBackend backend;
  SceneSource source(backend, {}, 0);
  const TimedEncoding run =
      RunEncoder(IdleEncoder(4), source, {64, 64}, 0.5, {}).value();
  EXPECT_EQ(run.encoding.grid.size, (GridSize{64, 64}));
  EXPECT_GT(run.render.wall_ms, 0);
  EXPECT_GT(run.encode.wall_ms, 0);
}

TEST(RunEncoder, RefusesAbsurdGridsBeforeRendering) {
  CountingBackend backend;
  SceneSource source(backend, {}, 0);
  const auto run = RunEncoder(IdleEncoder(17), source, {4096, 4096}, 0.5, {});
  ASSERT_FALSE(run.has_value());
  EXPECT_EQ(run.error().place, "--grid");
  EXPECT_EQ(backend.calls, 0);
}

}  // namespace
}  // namespace rtb
