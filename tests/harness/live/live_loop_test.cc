#include "harness/live/live_loop.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "core/base/file.h"
#include "encoders/parse/parse.h"
#include "harness/live/headless.h"
#include "harness/live/live_setup.h"
#include "tests/temp_folder.h"

namespace rtb {
namespace {

constexpr GridSize kGrid{24, 10};

/// A loop into memory on the scene `whitted`, as fast as it goes.
class LiveLoopTest : public testing::Test {
 protected:
  LiveLoopTest() {
    RTB_CHECK_EQ(::pipe2(keys_, O_CLOEXEC | O_NONBLOCK), 0);
    terminal_.input = keys_[0];
    terminal_.output = &output_;
    terminal_.presenter = presenter_.get();
    terminal_.size = [] { return kGrid; };
    terminal_.cell_aspect = [] { return 0.5; };
    options_.target_fps = 0;
    options_.paced = false;
    options_.step_seconds = 1.0 / 60;
  }
  ~LiveLoopTest() override {
    ::close(keys_[0]);
    ::close(keys_[1]);
  }

  void Press(std::string_view keys) {
    RTB_CHECK_EQ(::write(keys_[1], keys.data(), keys.size()),
                 static_cast<ssize_t>(keys.size()));
  }

  LiveLoop Make() {
    LiveRequest request;
    request.scene.scene =
        std::string(RTB_TEST_SOURCE_DIR) + "/scenes/whitted.yaml";
    auto state = MakeLiveState(request);
    RTB_CHECK(state.has_value());
    return {*state, options_, terminal_, wake_};
  }

  /// What a terminal shows after everything that was sent.
  CellGrid Shown() const {
    const auto shown = ParseAnsi(sent_, kGrid);
    EXPECT_TRUE(shown.has_value());
    return shown.value_or(CellGrid());
  }

  int keys_[2];
  std::string sent_;
  OutputQueue output_{[this](std::string_view bytes) { sent_ += bytes; }};
  std::unique_ptr<Presenter> presenter_ =
      MakeDirectPresenter(ColorDepth::kTruecolor);
  WakePipe wake_;
  LoopOptions options_;
  LoopTerminal terminal_;
};

TEST_F(LiveLoopTest, TheTerminalShowsWhatTheLoopHasDrawn) {
  options_.frames = 6;
  LiveLoop loop = Make();
  loop.state().modes().orbit = true;
  ASSERT_EQ(loop.Run(), 0);
  EXPECT_EQ(loop.totals().frames, 6);
  EXPECT_EQ(Canonical(Shown()), Canonical(loop.screen()));
}

/// Draws as another one does, and counts.
class CountingPresenter : public Presenter {
 public:
  explicit CountingPresenter(Presenter& other) : other_(other) {}
  const char* name() const override { return other_.name(); }
  Result<std::string> Draw(const ScreenUpdate& update) override {
    ++draws_;
    return other_.Draw(update);
  }
  int draws() const { return draws_; }

 private:
  Presenter& other_;
  int draws_ = 0;
};

// While the next picture is rendered nothing is drawn: what was left of the
// last one would be drawn over and over, by a core that the rendering lacks.
TEST_F(LiveLoopTest, DrawsEachMovingPictureOnce) {
  CountingPresenter counting(*presenter_);
  terminal_.presenter = &counting;
  options_.frames = 12;
  LiveLoop loop = Make();
  loop.state().modes().orbit = true;
  loop.state().modes().orbit_reach = 0.02;  // Little changes: much is left.
  ASSERT_EQ(loop.Run(), 0);
  EXPECT_EQ(counting.draws(), 12);
}

TEST_F(LiveLoopTest, ARecordingReplaysToTheSameScreen) {
  const TempFolder folder;
  const std::string file = folder / "a.cast";
  options_.frames = 8;
  LiveLoop loop = Make();
  loop.state().modes().orbit = true;
  ASSERT_TRUE(loop.StartRecording(file));
  Press("?n");  // Help over the picture, and another encoder.
  ASSERT_EQ(loop.Run(), 0);
  std::istringstream lines(*ReadFile(file));
  std::string line, replayed;
  std::getline(lines, line);
  while (std::getline(lines, line)) {
    const auto event = nlohmann::json::parse(line);
    if (event[1] == "o") replayed += event[2].get<std::string>();
  }
  const auto shown = ParseAnsi(replayed, kGrid);
  ASSERT_TRUE(shown.has_value());
  EXPECT_EQ(Canonical(*shown), Canonical(loop.screen()));
}

TEST_F(LiveLoopTest, EndsByKey) {
  LiveLoop loop = Make();
  Press("w\x03");
  EXPECT_EQ(loop.Run(), 0);
}

TEST_F(LiveLoopTest, EndsBySignal) {
  SignalCatcher signals(wake_);
  terminal_.signals = &signals;
  LiveLoop loop = Make();
  ::raise(SIGTERM);
  EXPECT_EQ(loop.Run(), SIGTERM);
}

TEST_F(LiveLoopTest, SynchronizedFramesAreBracketed) {
  options_.frames = 2;
  options_.sync = true;
  LiveLoop loop = Make();
  loop.state().modes().orbit = true;
  ASSERT_EQ(loop.Run(), 0);
  EXPECT_TRUE(sent_.starts_with("\x1b[?2026h"));
  EXPECT_TRUE(sent_.ends_with("\x1b[?2026l"));
}

TEST_F(LiveLoopTest, AnEncoderThatFailsAtOnceIsAnError) {
  LiveRequest request;
  request.scene.scene = "no/such/scene.yaml";
  EXPECT_FALSE(MakeLiveState(request));
  request.scene.scene =
      std::string(RTB_TEST_SOURCE_DIR) + "/scenes/whitted.yaml";
  request.encoder = "half,tiv,quadrant";
  EXPECT_FALSE(MakeLiveState(request));
}

TEST(Headless, MeasuresTheLoop) {
  LiveRequest request;
  request.scene.scene =
      std::string(RTB_TEST_SOURCE_DIR) + "/scenes/whitted.yaml";
  request.grid = kGrid;
  request.frames = 5;
  request.warmup = 1;
  request.target_fps = 0;
  for (const PresentMode mode : {PresentMode::kDirect, PresentMode::kString}) {
    request.present = mode;
    const auto figures = RunHeadless(request);
    ASSERT_TRUE(figures.has_value()) << figures.error().ToString();
    EXPECT_EQ(figures->frames, 5);
    EXPECT_DOUBLE_EQ(figures->rays_per_cell, 4);  // Quadrant's 2 x 2.
    EXPECT_GT(figures->bytes_per_frame, 0);
    EXPECT_GT(figures->fps, 0);
    EXPECT_LE(figures->frame_ms.p50, figures->frame_ms.p99);
    EXPECT_LE(figures->cells_per_frame, kGrid.cells());
    EXPECT_EQ(FiguresToJson(*figures)["grid"], Json::array({24, 10}));
  }
}

TEST(Headless, SplitScreensAndTakingTurnsDrawEveryRow) {
  LiveRequest request;
  request.scene.scene =
      std::string(RTB_TEST_SOURCE_DIR) + "/scenes/whitted.yaml";
  LiveView view;
  view.scene = request.scene.scene;
  view.encoders = {"quadrant", "half"};
  view.grid = kGrid;
  view.split = true;
  view.divider = 9;
  FrameMaker maker;
  FrameRequest whole{view, {}};
  const auto first = maker.Make(whole);
  ASSERT_TRUE(first.has_value());
  EXPECT_EQ(first->passes, 1);
  // 9 columns of 4 samples, 15 of 2.
  EXPECT_DOUBLE_EQ(first->rays_per_cell, (9 * 4 + 15 * 2) / 24.0);
  // In turns of three rows the same picture comes about in three frames.
  FrameMaker turns;
  FrameRequest third{view, {.spp = 1, .share = 1, .row_step = 3}};
  EXPECT_EQ(turns.Make(third)->passes, 0);
  EXPECT_EQ(turns.Make(third)->passes, 0);
  const auto last = turns.Make(third);
  ASSERT_TRUE(last.has_value());
  EXPECT_EQ(last->passes, 1);
  EXPECT_EQ(last->picture, first->picture);
}

}  // namespace
}  // namespace rtb
