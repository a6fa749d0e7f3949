#include "harness/bench.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "encoders/emit/emit.h"
#include "tests/harness/temporary_folder.h"

namespace rtb {
namespace {

using ::testing::ElementsAre;
using ::testing::Gt;
using ::testing::Optional;

constexpr char kScene[] =
    "rtbench_scene: 1\n"
    "name: sky\n"
    "camera: {position: [0, 0, 0], look_at: [0, 0, -1], vfov: 40}\n"
    "background: {type: constant, color: [0.25, 0.5, 0]}\n"
    "settings: {exposure: 1}\n";

class BenchTest : public ::testing::Test {
 protected:
  BenchTest() {
    request_.scene.scene = folder_.Write("sky.yaml", kScene).string();
    request_.encoders = "half,quadrant";
    request_.grid = {6, 2};
    request_.repeat = 3;
  }

  Result<BenchResult> Run() {
    return Bench(request_, [this](double share, const std::string&) {
      EXPECT_GT(share, share_);
      share_ = share;
    });
  }

  TemporaryFolder folder_;
  BenchRequest request_;
  double share_ = 0;
};

// One color everywhere: any encoder draws it exactly. Exposed by the scene's
// stop it is (0.5, 1, 0): codes 188 (187.516), 255 and 0.
TEST_F(BenchTest, AUniformSceneIsDrawnExactly) {
  const BenchResult result = Run().value();
  ASSERT_EQ(result.pictures.size(), 2u);
  EXPECT_EQ(result.pictures[0].encoder, "half");
  EXPECT_EQ(result.pictures[0].grid.size, (GridSize{6, 2}));
  EXPECT_EQ(result.pictures[0].grid.at(5, 1).fg, (Rgb8{188, 255, 0}));
  EXPECT_EQ(result.pictures[1].decoded.width(), 48);
  for (const RunResult& run : result.record.runs) {
    EXPECT_EQ(FindMetricValue(run, "mse"), 0);
    EXPECT_EQ(FindMetricValue(run, "psnr"), std::nullopt);
    EXPECT_EQ(FindMetricValue(run, "flip"), 0);
  }
}

TEST_F(BenchTest, RecordsWhatWasDone) {
  request_.scene.options.seed = 9;
  request_.scene.exposure = -1;
  const RunRecord record = Run()->record;
  EXPECT_EQ(record.manifest.settings.backend, "embree");
  EXPECT_EQ(record.manifest.settings.seed, 9u);
  EXPECT_EQ(record.manifest.settings.exposure, -1);
  EXPECT_EQ(record.manifest.settings.max_depth, 8);  // the format's default
  EXPECT_EQ(record.manifest.settings.reference, "self");
  ASSERT_EQ(record.manifest.inputs.size(), 1u);
  EXPECT_EQ(record.manifest.inputs[0].name, "sky.yaml");
  ASSERT_EQ(record.runs.size(), 2u);
  EXPECT_EQ(record.runs[1].rays_per_cell, 4);
  EXPECT_EQ(record.runs[1].raster, (PixelSize{48, 32}));
}

TEST_F(BenchTest, RecordsEveryFileThatItOpened) {
  folder_.Write("a.obj", "v 0 0 -5\nv 1 0 -5\nv 0 1 -5\nf 1 2 3\n");
  folder_.Write("sky.yaml",
                std::string(kScene) + "objects: [{type: mesh, file: a.obj}]\n");
  request_.encoders = "half,braille";
  request_.scene.options.max_depth = 3;
  const Manifest manifest = Run()->record.manifest;
  std::vector<std::string> opened;
  for (const InputFile& input : manifest.inputs) {
    opened.push_back(input.role + " " + input.name);
  }
  // Braille patterns are drawn by a font, which the first of the chain lacks.
  EXPECT_THAT(opened,
              ElementsAre("scene sky.yaml", "mesh a.obj",
                          "font DejaVuSansMono.ttf", "font DejaVuSans.ttf"));
  EXPECT_EQ(manifest.settings.max_depth, 3);
}

TEST_F(BenchTest, TakesAsManyTimesAsAsked) {
  const RunRecord record = Run()->record;
  for (const RunResult& run : record.runs) {
    for (const char* stage : {"plan", "render", "encode"}) {
      const StageTimes* times = FindStage(run, stage);
      ASSERT_NE(times, nullptr);
      EXPECT_EQ(times->samples.size(), 3u);
      EXPECT_EQ(times->cpu_samples.size(), 3u);
    }
    EXPECT_THAT(FramesPerSecond(run), Optional(Gt(0.0)));
  }
  EXPECT_EQ(share_, 1);
}

TEST_F(BenchTest, TimesWhatIsAroundTheFrameToo) {
  const RunRecord record = Run()->record;
  std::vector<std::string> stages;
  for (const StageTimes& times : record.runs[1].times) {
    stages.push_back(times.stage);
    EXPECT_EQ(times.samples.size(), 3u);
  }
  EXPECT_THAT(stages, ElementsAre("load", "build", "plan", "render", "encode",
                                  "decode", "emit"));
}

// `half` takes 2 samples a cell, of 3 rays each: 12 cells take 72 eye rays,
// which meet nothing.
TEST_F(BenchTest, CountsRaysAndBytesOfOneFrame) {
  request_.scene.options.spp = 3;
  const BenchResult result = Run().value();
  const RunResult& run = result.record.runs[0];
  EXPECT_EQ(run.rays, (RayCounts{72, 0, 0, 0, 0}));
  EXPECT_EQ(run.bytes_per_frame, EmitAnsi(result.pictures[0].grid).size());
}

TEST_F(BenchTest, WithoutRepeatsNothingIsTimed) {
  request_.repeat = 0;
  const RunRecord record = Run()->record;
  for (const RunResult& run : record.runs) {
    EXPECT_TRUE(run.times.empty());
    EXPECT_EQ(FindMetricValue(run, "mse"), 0);
    EXPECT_TRUE(run.rays.has_value());
  }
  EXPECT_EQ(share_, 1);
}

TEST_F(BenchTest, WithoutScoresThereIsNoReference) {
  request_.score = false;
  request_.reference = "povray";  // There is none.
  const BenchResult result = Run().value();
  EXPECT_TRUE(result.reference.empty());
  EXPECT_TRUE(result.record.runs[0].metrics.empty());
  EXPECT_EQ(result.record.runs[0].times.size(), 7u);
  EXPECT_EQ(result.record.manifest.settings.reference, "none");
}

// The picture is of one color: nothing is lost but rounding, which the
// reference has too.
TEST_F(BenchTest, DecomposesOnRequest) {
  request_.decompose = true;
  request_.cache = folder_.path() / "cache";
  const RunRecord record = Run()->record;
  for (const RunResult& run : record.runs) {
    ASSERT_TRUE(run.decomposition.has_value());
    EXPECT_EQ(run.decomposition->mse.total, 0);
    EXPECT_NEAR(run.decomposition->mse.render, 0, 1 / (255.0 * 255.0));
    EXPECT_NEAR(run.decomposition->mse.sampling, 0, 1e-12);
    ASSERT_TRUE(run.bound.has_value());
    EXPECT_NEAR(run.bound->mse, 0, 1e-12);
  }
  EXPECT_FALSE(std::filesystem::is_empty(request_.cache));
}

TEST_F(BenchTest, FailsBeforeTheWork) {
  request_.encoders = "half,thirds";
  EXPECT_FALSE(Run().has_value());
  request_.encoders = "half";
  request_.decode.font = "gone.ttf";
  EXPECT_FALSE(Run().has_value());
  request_.decode.font.clear();
  request_.grid = {4096, 4096};
  const auto result = Run();
  ASSERT_FALSE(result.has_value());
  EXPECT_EQ(result.error().place, "--grid");
  EXPECT_EQ(share_, 0);
}

}  // namespace
}  // namespace rtb
