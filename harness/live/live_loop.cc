#include "harness/live/live_loop.h"

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "harness/live/free_name.h"
#include "harness/live/screenshot.h"

namespace rtb {
namespace {

// Escape alone is a key when nothing follows for so long.
constexpr double kEscapeSeconds = 0.025;
// Nothing waits for longer: the panel's figures are to be drawn anew.
constexpr double kPanelSeconds = 0.5;

}  // namespace

LiveLoop::LiveLoop(LiveState state, LoopOptions options, LoopTerminal terminal,
                   const WakePipe& wake)
    : state_(std::move(state)),
      options_(std::move(options)),
      terminal_(std::move(terminal)),
      wake_(wake),
      governor_(options_.target_fps),
      fence_(options_.fence),
      times_(static_cast<std::size_t>(std::max(options_.frames, 120))),
      thread_([&wake] { wake.Wake(); }) {
  state_.modes().governor = options_.target_fps > 0;
  Resized();
}

double LiveLoop::Now() const {
  return std::chrono::duration<double>(Clock::now() - start_).count();
}

Result<int> LiveLoop::Run() {
  while (!done_) RTB_RETURN_IF_ERROR(Round());
  Drain();
  recorder_.reset();
  totals_.intervals_ms = times_.Intervals();
  return signal_;
}

Status LiveLoop::Round() {
  RTB_RETURN_IF_ERROR(HandleSignals());
  ReadInput();
  Advance();
  DoActions();
  RTB_RETURN_IF_ERROR(terminal_.output->Flush());
  RTB_RETURN_IF_ERROR(TakePicture());
  if (state_.modes().quality != (quality_ != nullptr)) JudgeQuality();
  RequestPicture();  // Before drawing: both go on at the same time.
  if (MayDraw()) RTB_RETURN_IF_ERROR(Draw());
  RequestPicture();
  if (!done_) Wait();
  return {};
}

int LiveLoop::WaitMilliseconds(double now) const {
  double until = now + kPanelSeconds;
  if ((PictureWanted() || state_.moving(now)) && !thread_.busy()) {
    until = std::min(until, next_request_);
  }
  if (parser_.pending()) until = std::min(until, last_input_ + kEscapeSeconds);
  if (undrawn_ || dirty_) until = std::min(until, fence_.Deadline());
  if (Leftovers()) until = fence_.waiting() ? fence_.Deadline() : now;
  return static_cast<int>(std::ceil(std::max(0.0, until - now) * 1e3));
}

void LiveLoop::Wait() {
  const bool writing = !terminal_.output->empty();
  pollfd waits[] = {{wake_.fd(), POLLIN, 0},
                    {terminal_.input, POLLIN, 0},
                    {writing ? terminal_.output->fd() : -1, POLLOUT, 0}};
  ::poll(waits, std::size(waits), WaitMilliseconds(Now()));
  wake_.Clear();
}

Status LiveLoop::HandleSignals() {
  if (terminal_.signals == nullptr) return {};
  while (const auto signal = terminal_.signals->Take()) {
    if (*signal == SIGWINCH) {
      Resized();
    } else if (*signal == SIGTSTP) {
      Suspend();
    } else if (*signal == SIGCONT) {  // After a stop that nobody could catch.
      Resume();
    } else {
      signal_ = *signal;
      done_ = true;
    }
  }
  return {};
}

void LiveLoop::Suspend() {
  if (!terminal_.suspend) return;
  Drain();
  terminal_.suspend();
  // Its own SIGCONT, and what was pressed to stop it.
  while (terminal_.signals->Take()) {
  }
  Resume();
}

void LiveLoop::Resume() {
  if (terminal_.resume) terminal_.resume();
  state_.ReleaseKeys();
  times_.Pause();
  Resized();
}

void LiveLoop::Resized() {
  state_.Resize(terminal_.size());
  state_.set_cell_aspect(terminal_.cell_aspect());
  diff_.Invalidate();
  if (recorder_) {
    static_cast<void>(recorder_->Resize(state_.terminal(), Now()));
  }
  dirty_ = true;
}

void LiveLoop::FeedInput(std::string_view bytes) {
  const double now = Now();
  last_input_ = now;
  for (const InputEvent& event : parser_.Feed(bytes)) {
    if (const auto* reply = std::get_if<ReplyEvent>(&event)) {
      if (reply->kind == ReplyEvent::Kind::kStatus) fence_.Answered(now);
      continue;
    }
    state_.Handle(event, now);
    dirty_ = true;
  }
}

void LiveLoop::ReadInput() {
  if (terminal_.input < 0) return;
  char bytes[4096];
  for (ssize_t count;
       (count = ::read(terminal_.input, bytes, sizeof bytes)) > 0;) {
    FeedInput({bytes, static_cast<std::size_t>(count)});
  }
  if (!parser_.pending() || Now() - last_input_ < kEscapeSeconds) return;
  for (const InputEvent& event : parser_.Flush()) {
    state_.Handle(event, Now());
    dirty_ = true;
  }
}

void LiveLoop::Advance() {
  if (options_.step_seconds > 0) return;  // Goes by pictures.
  const double now = Now();
  // A long pause is no long step.
  constexpr double kLongest = 0.25;
  state_.Step(now, std::min(now - last_step_, kLongest));
  last_step_ = now;
}

void LiveLoop::DoActions() {
  for (const LiveCommand action : state_.TakeActions()) {
    if (action == LiveCommand::kQuit) {
      done_ = true;
    } else if (action == LiveCommand::kRedraw) {
      diff_.Invalidate();
    } else if (action == LiveCommand::kSuspend) {
      Suspend();
    } else if (action == LiveCommand::kScreenshot) {
      TakeScreenshot();
    } else if (action == LiveCommand::kRecord) {
      ToggleRecording();
    }
    dirty_ = true;
  }
}

void LiveLoop::TakeScreenshot() {
  if (!frame_) return;
  const auto name =
      WriteScreenshot(frame_->picture, frame_->request.view.depth);
  state_.Log(name ? "wrote " + *name + ".png" : name.error().ToString());
}

Status LiveLoop::StartRecording(const std::string& file) {
  std::string name = file;
  if (name.empty()) {
    RTB_ASSIGN_OR_RETURN(name, FreeName({".cast"}));
    name += ".cast";
  }
  RTB_ASSIGN_OR_RETURN(recorder_,
                       Recorder::Start(name, state_.terminal(), Now()));
  state_.Log("records into " + name);
  diff_.Invalidate();  // A recording begins with the whole screen.
  return {};
}

void LiveLoop::ToggleRecording() {
  if (recorder_) {
    state_.Log("recorded " + recorder_->file());
    recorder_.reset();
  } else if (const Status started = StartRecording(""); !started) {
    state_.Log(started.error().ToString());
  }
}

bool LiveLoop::PictureWanted() const {
  if (!requested_ || !frame_) return true;
  if (!SamePicture(requested_->view, state_.view())) return true;
  if (!SamePicture(frame_->request.view, state_.view())) return false;
  return frame_->passes < kEnoughPasses;
}

void LiveLoop::RequestPicture() {
  const double now = Now();
  if (done_ || thread_.busy() || now < next_request_) return;
  if (undrawn_ && !options_.paced) return;  // Every picture is to be seen.
  if (options_.step_seconds > 0 && requested_) {
    state_.Step(now, options_.step_seconds);
  }
  if (!PictureWanted() && options_.frames == 0) return;
  governor_.set_target_fps(
      state_.modes().governor
          ? (options_.target_fps > 0 ? options_.target_fps : 60)
          : 0);
  requested_ = FrameRequest{state_.view(), governor_.budget()};
  thread_.Request(*requested_);
  const double rate = options_.target_fps > 0 ? options_.target_fps : 60;
  if (options_.paced) next_request_ = std::max(next_request_ + 1 / rate, now);
}

Status LiveLoop::TakePicture() {
  auto taken = thread_.Take();
  if (!taken) return {};
  if (!*taken) {
    if (!frame_) return Fail((*taken).error());
    state_.Log((*taken).error().ToString());
    state_.RejectScene();
    requested_.reset();
    dirty_ = true;
    return {};
  }
  resting_ =
      frame_ && SameSamples(frame_->request.view, (*taken)->request.view);
  frame_ = std::move(**taken);
  undrawn_ = true;
  NotePicture();
  return {};
}

void LiveLoop::NotePicture() {
  const LiveFrame& frame = *frame_;
  if (frame.loaded && frame.request.view.scene == state_.view().scene) {
    state_.Adopt(frame.scene);
  }
  const RayBudget& budget = frame.request.budget;
  if (!frame.loaded && budget == governor_.budget()) {
    governor_.Note(frame.render_ms, frame.encode_ms);
  }
  governor_.Describe(frame.request.view.spp, frame.samples_per_cell);
  render_ms_.Add(frame.render_ms);
  encode_ms_.Add(frame.encode_ms);
  rays_.Add(static_cast<double>(frame.rays.total()));
  readings_.rays_per_cell = frame.rays_per_cell;
  readings_.share = budget.share;
  readings_.row_step = budget.row_step;
  readings_.passes = frame.passes;
  readings_.exposure = frame.exposure;
  JudgeQuality();
}

void LiveLoop::JudgeQuality() {
  if (!state_.modes().quality || !frame_) {
    quality_.reset();
    return;
  }
  if (!quality_) quality_ = std::make_unique<QualityMeter>();
  if (!resting_) {
    quality_->Forget();
  } else {
    quality_->Show(frame_->request.view, frame_->picture);
  }
}

}  // namespace rtb
