// LiveLoop's other half: what goes to the terminal.
#include <poll.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "harness/cpu_time.h"
#include "harness/live/live_loop.h"

namespace rtb {
namespace {

// The panel's figures are drawn anew so often while nothing else changes.
constexpr double kPanelSeconds = 0.5;
// Difference in look that may wait while the picture moves.
constexpr float kMovingThreshold = 6;

/// How much more or less difference may wait with so many rays in every sample
/// of a picture at rest. The first few change much; then the noise shrinks with
/// the square root, and so does what may stay; in the end nothing may.
float Patience(int passes) {
  constexpr int kFew = 4;
  constexpr int kSettled = 32;
  if (passes >= LiveLoop::kEnoughPasses) return 0;
  if (passes > 0 && passes < kFew) return 2;
  return std::sqrt(static_cast<float>(kSettled) /
                   static_cast<float>(std::max(passes, kSettled)));
}

}  // namespace

bool LiveLoop::Leftovers() const {
  // While another picture is under way, that one will say what is left.
  return frame_ && !diff_.exact() && !PictureWanted() &&
         SamePicture(frame_->request.view, state_.view());
}

bool LiveLoop::MayDraw() {
  const double now = Now();
  const bool panel_due =
      state_.modes().panel && now - last_panel_ >= kPanelSeconds;
  const bool waiting = undrawn_ || dirty_ || panel_due || Leftovers();
  return waiting && frame_ && terminal_.output->empty() && fence_.Open(now);
}

DiffLimits LiveLoop::Limits() const {
  DiffLimits limits;
  if (!state_.view().temporal) return limits;
  const int passes = resting_ ? frame_->passes : 0;
  if (resting_) limits.oldest = 4 * kEnoughPasses;  // The end sends it all.
  limits.threshold = kMovingThreshold * Patience(passes);
  if (options_.paced && fence_.cells_per_second() > 0) {
    constexpr double kFewest = 400;
    limits.budget = static_cast<int>(std::min(
        1e9, std::max(kFewest, fence_.cells_per_second() /
                                   std::max(options_.target_fps, 1.0))));
  }
  return limits;
}

CellGrid LiveLoop::Compose() const {
  CellGrid screen(state_.terminal());
  const CellGrid& picture = frame_->picture;
  const GridSize room = state_.view().grid;
  for (int row = 0; row < std::min(room.rows, picture.size.rows); ++row) {
    for (int column = 0; column < std::min(room.columns, picture.size.columns);
         ++column) {
      screen.at(column, row) = picture.at(column, row);
    }
  }
  DrawOverlays(state_, readings_, options_.depth, &screen);
  return screen;
}

Status LiveLoop::Draw() {
  const double start = Now();
  RefreshReadings();
  const CellGrid screen = Compose();
  const std::vector<int> changed = diff_.Select(screen, Limits());
  RTB_ASSIGN_OR_RETURN(
      std::string bytes,
      terminal_.presenter->Draw({diff_.shown(), changed, diff_.cleared()}));
  const std::size_t size = bytes.size();
  const bool picture = undrawn_;
  undrawn_ = false;
  dirty_ = false;
  if (!changed.empty() || diff_.cleared()) {
    RTB_RETURN_IF_ERROR(
        Send(std::move(bytes), static_cast<int>(changed.size())));
  }
  if (picture) NoteDrawn(start, size, changed.size());
  return {};
}

Status LiveLoop::Send(std::string bytes, int cells) {
  if (recorder_ && !recorder_->Output(bytes, Now())) {
    state_.Log("the recording broke off: " + recorder_->file());
    recorder_.reset();
  }
  if (options_.sync) bytes = "\x1b[?2026h" + bytes + "\x1b[?2026l";
  if (fence_.on()) bytes += Fence::kQuestion;
  fence_.Sent(Now(), cells);
  return terminal_.output->Push(bytes);
}

void LiveLoop::NoteDrawn(double start, std::size_t bytes, std::size_t cells) {
  const double now = Now();
  const double draw_ms = (now - start) * 1e3;
  draw_ms_.Add(draw_ms);
  bytes_.Add(static_cast<double>(bytes));
  changed_.Add(static_cast<double>(cells) / state_.terminal().cells());
  if (resting_ && frame_->passes >= kEnoughPasses) times_.Pause();
  if (++drawn_ <= options_.warmup) return;
  times_.Add(now);
  if (totals_.frames == 0) {
    first_drawn_ = now;
    first_cpu_ms_ = CpuMilliseconds();
  }
  totals_.render_ms += frame_->render_ms;
  totals_.encode_ms += frame_->encode_ms;
  totals_.eye_rays_per_cell += frame_->rays_per_cell;
  totals_.seconds = now - first_drawn_;
  totals_.cpu_ms = CpuMilliseconds() - first_cpu_ms_;
  totals_.differ += diff_.differing();
  ++totals_.frames;
  if (options_.frames > 0) totals_.draw_ms.push_back(draw_ms);
  totals_.bytes += static_cast<double>(bytes);
  totals_.cells += static_cast<double>(cells);
  if (options_.frames > 0 && totals_.frames >= options_.frames) done_ = true;
}

void LiveLoop::RefreshReadings() {
  const double now = Now();
  constexpr double kReadable = 0.25;  // Seconds that figures stand.
  if (now - last_panel_ < kReadable) return;
  last_panel_ = now;
  LiveReadings& r = readings_;
  const std::vector<double> intervals = times_.Intervals();
  r.fps = times_.Rate();
  r.target_fps = governor_.target_fps();
  r.frame_p50_ms = Percentile(intervals, 0.5);
  r.frame_p99_ms = Percentile(intervals, 0.99);
  r.render_ms = render_ms_.mean();
  r.encode_ms = encode_ms_.mean();
  r.draw_ms = draw_ms_.mean();
  r.ack_ms = fence_.on() ? fence_.latency_ms() : 0;
  constexpr double kGraphTop = 50;  // Milliseconds: 20 frames a second.
  r.graph = times_.Graph(30, kGraphTop);
  r.rays_per_second = rays_.mean() * r.fps;
  r.bytes_per_frame = bytes_.mean();
  r.bytes_per_second = bytes_.mean() * r.fps;
  r.changed = changed_.mean();
  r.present = PresentName();
  r.color_reason = options_.color_reason;
  r.recording = recorder_.has_value();
  r.quality = quality_ ? quality_->latest() : std::nullopt;
}

std::string LiveLoop::PresentName() const {
  return std::string(terminal_.presenter->name()) +
         (options_.sync ? ", sync" : "") + (fence_.on() ? ", fence" : "");
}

void LiveLoop::Drain() {
  // Answers that come later would be typed into the shell.
  constexpr double kPatience = 0.1;
  const double deadline = Now() + kPatience;
  while (Now() < deadline && (fence_.waiting() || !terminal_.output->empty())) {
    if (!terminal_.output->Flush()) return;
    pollfd waits[] = {{terminal_.input, POLLIN, 0},
                      {terminal_.output->fd(), POLLOUT, 0}};
    const bool writing = !terminal_.output->empty();
    ::poll(waits, writing ? 2 : 1, 5);
    ReadInput();
  }
}

}  // namespace rtb
