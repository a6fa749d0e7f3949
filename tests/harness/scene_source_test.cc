#include "harness/scene_source.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

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
    for (int entry = 0; entry < plan.entries(); ++entry) {
      for (int i = 0; i < plan.samples_per_cell; ++i) {
        fragments.cell(entry)[static_cast<std::size_t>(i)] =
            Rgb(static_cast<float>(100 * plan.cell(entry) + i));
      }
    }
    return fragments;
  }

  /// A render takes 5 rays.
  RayCounts ray_counts() const override { return {3, 0, 0, 0, 2}; }

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

TEST(SceneSource, CountsTheRaysOfAllQueries) {
  CountingBackend backend;
  SceneSource source(backend, {}, 0);
  EXPECT_EQ(source.rays().total(), 0u);
  ASSERT_TRUE(source.Query(RegularPlan({2, 1}, 2, 1)).has_value());
  ASSERT_TRUE(source.Query(RegularPlan({2, 1}, 2, 1)).has_value());
  EXPECT_EQ(source.rays(), (RayCounts{6, 0, 0, 0, 4}));
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

TEST(RenderImage, TracesManyRaysInBandsAndSaysHowFarItIs) {
  CountingBackend backend;
  RenderOptions options;
  options.spp = 1 << 20;  // A band holds 2^22 rays: one row of 3 pixels.
  std::vector<double> shares;
  const Image image = RenderImage(backend, {3, 4}, options, [&](double share) {
                        shares.push_back(share);
                      }).value();
  EXPECT_EQ(backend.calls, 4);
  EXPECT_EQ(shares, (std::vector{0.25, 0.5, 0.75, 1.0}));
  EXPECT_EQ(image.at(2, 0), Rgb(200.0f));
  EXPECT_EQ(image.at(1, 3), Rgb(1000.0f));
}

/// How long each part takes on purpose, in milliseconds.
struct Delays {
  int plan = 0;
  int query = 0;
  int encode = 0;
};

void Sleep(int ms) {
  std::this_thread::sleep_for(std::chrono::milliseconds(ms));
}

/// Plans `samples` a cell and draws nothing.
class IdleEncoder : public PlanEncoder {
 public:
  explicit IdleEncoder(int samples, Delays delays = {})
      : samples_(samples), delays_(delays) {}
  SamplePlan Plan(GridSize grid, double aspect,
                  std::uint64_t /*seed*/) const override {
    Sleep(delays_.plan);
    return RegularPlan(grid, samples_, 1, aspect);
  }
  Result<CellGrid> Encode(const Fragments& fragments,
                          const EncodeContext& /*context*/) const override {
    Sleep(delays_.encode);
    return CellGrid(fragments.grid);
  }

 private:
  int samples_;
  Delays delays_;
};

/// Answers late.
class LateSource : public FragmentSource {
 public:
  explicit LateSource(int ms) : ms_(ms) {}
  Result<Fragments> Query(const SamplePlan& plan) override {
    Sleep(ms_);
    return Fragments(plan);
  }

 private:
  int ms_;
};

// A sleep is never too short, so each part takes at least its own, and no
// other part can have it: each in turn is the longest by far.
TEST(RunEncoder, TimesItsPartsApart) {
  constexpr int kLong = 200;
  const auto run = [](const Delays& delays) {
    LateSource source(delays.query);
    return RunEncoder(IdleEncoder(4, delays), source, {2, 2}, 0.5, {}).value();
  };
  const TimedEncoding plan = run({kLong, 0, 0});
  EXPECT_GE(plan.plan.wall_ms, kLong);
  EXPECT_LT(plan.render.wall_ms, kLong);
  EXPECT_LT(plan.encode.wall_ms, kLong);
  const TimedEncoding query = run({0, kLong, 0});
  EXPECT_LT(query.plan.wall_ms, kLong);
  EXPECT_GE(query.render.wall_ms, kLong);
  EXPECT_LT(query.encode.wall_ms, kLong);
  const TimedEncoding encode = run({0, 0, kLong});
  EXPECT_LT(encode.plan.wall_ms, kLong);
  EXPECT_LT(encode.render.wall_ms, kLong);
  EXPECT_GE(encode.encode.wall_ms, kLong);
  EXPECT_EQ(encode.encoding.grid.size, (GridSize{2, 2}));
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
