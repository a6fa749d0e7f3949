/// @file
/// LiveLoop: input, pictures and drawing, until somebody quits. The next
/// picture is made (FrameThread) while this one is drawn.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "harness/live/fence.h"
#include "harness/live/frame_thread.h"
#include "harness/live/frame_times.h"
#include "harness/live/governor.h"
#include "harness/live/input_parser.h"
#include "harness/live/live_state.h"
#include "harness/live/output_queue.h"
#include "harness/live/panel.h"
#include "harness/live/presenter.h"
#include "harness/live/quality_meter.h"
#include "harness/live/recorder.h"
#include "harness/live/screen_diff.h"
#include "harness/live/signals.h"

namespace rtb {

/// How a loop runs.
struct LoopOptions {
  double target_fps = 60;  ///< 0: the governor is off, and 60 is the pace.
  bool paced = true;       ///< Keep to the rate; else as fast as it goes.
  int frames = 0;          ///< End after that many pictures; 0: never.
  int warmup = 0;          ///< Pictures before those, not measured.
  /// Seconds that go by from picture to picture; 0: those of the clock.
  double step_seconds = 0;
  bool sync = false;  ///< Synchronized output around every frame.
  bool fence = false;
  ColorDepth depth = ColorDepth::kTruecolor;  ///< The terminal's.
  std::string color_reason;
};

/// What a loop draws on.
struct LoopTerminal {
  int input = -1;  ///< Descriptor; -1: no input.
  OutputQueue* output = nullptr;
  Presenter* presenter = nullptr;
  std::function<GridSize()> size;       ///< Asked after SIGWINCH.
  std::function<double()> cell_aspect;  ///< Likewise.
  /// Gives the terminal back and stops the program; returns when it goes on.
  std::function<void()> suspend;
  std::function<void()> resume;      ///< Takes the terminal over again.
  SignalCatcher* signals = nullptr;  ///< May be nullptr.
};

/// What a loop has measured, over all of its pictures.
struct LoopTotals {
  int frames = 0;
  double seconds = 0;  ///< From the first picture to the last.
  std::vector<double> intervals_ms;
  std::vector<double> draw_ms;  ///< All after encoding.
  double bytes = 0;
  double cells = 0;   ///< That were sent.
  double differ = 0;  ///< Whose glyph or colors are not the last frame's.
  double eye_rays_per_cell = 0;  ///< Sums over frames.
  double render_ms = 0;
  double encode_ms = 0;
  double cpu_ms = 0;  ///< Of all threads, from the first picture to the last.
};

/// One session.
class LiveLoop {
 public:
  /// A picture at rest is good enough with so many rays in every sample.
  static constexpr int kEnoughPasses = SampleStore::kMostRays;

  /// Everything that is referred to must outlive the loop.
  LiveLoop(LiveState state, LoopOptions options, LoopTerminal terminal,
           const WakePipe& wake);

  /// Runs to the end.
  /// @return the signal that ended it, 0 for none; kFailure when the terminal
  /// is gone, and the error of the first picture.
  Result<int> Run();

  /// Bytes that have come in before.
  void FeedInput(std::string_view bytes);

  LiveState& state() { return state_; }
  const LoopTotals& totals() const { return totals_; }
  /// What is on the screen.
  const CellGrid& screen() const { return diff_.shown(); }
  /// The kinds of terminal output that the session uses.
  std::string PresentName() const;
  /// Starts recording.
  Status StartRecording(const std::string& file);

 private:
  using Clock = std::chrono::steady_clock;
  double Now() const;

  Status Round();
  void Wait();
  int WaitMilliseconds(double now) const;
  Status HandleSignals();
  void ReadInput();
  void Advance();
  void DoActions();
  void Suspend();
  void Resume();
  void Resized();
  void RequestPicture();
  bool PictureWanted() const;
  Status TakePicture();
  void NotePicture();
  bool MayDraw();
  Status Draw();
  CellGrid Compose() const;
  DiffLimits Limits() const;
  Status Send(std::string bytes, int cells);
  void NoteDrawn(double start, std::size_t bytes, std::size_t cells);
  void RefreshReadings();
  void Drain();
  bool Leftovers() const;
  void TakeScreenshot();
  void ToggleRecording();
  void JudgeQuality();

  LiveState state_;
  LoopOptions options_;
  LoopTerminal terminal_;
  const WakePipe& wake_;
  Clock::time_point start_ = Clock::now();

  InputParser parser_;
  double last_input_ = 0;
  double last_step_ = 0;
  Governor governor_;
  Fence fence_;
  ScreenDiff diff_;
  FrameTimes times_;
  MovingMean render_ms_, encode_ms_, draw_ms_, bytes_, changed_, rays_;
  LiveReadings readings_;
  LoopTotals totals_;
  std::optional<Recorder> recorder_;
  std::unique_ptr<QualityMeter> quality_;  ///< While the overlay is on.

  std::optional<LiveFrame> frame_;  ///< The newest.
  bool undrawn_ = false;            ///< It is not on the screen yet.
  bool dirty_ = true;               ///< Something beside it has changed.
  std::optional<FrameRequest> requested_;
  double next_request_ = 0;
  double first_drawn_ = 0;
  double first_cpu_ms_ = 0;
  int drawn_ = 0;             ///< Pictures, warm-up included.
  double last_panel_ = -1e9;  ///< When the figures were read.
  bool resting_ = false;      ///< The last picture was of the same view.
  bool done_ = false;
  int signal_ = 0;
  FrameThread thread_;  ///< Last, so that it ends first.
};

}  // namespace rtb
