#include "harness/live/live_state.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/error.h"
#include "harness/live/scene_speed.h"

namespace rtb {
namespace {

constexpr std::size_t kLogLines = 50;
constexpr double kStepSeconds = 1.0 / 24;
constexpr double kLatest = 1e9;       // Seconds; the command line's limit.
constexpr double kOrbitSpeed = 0.35;  // Radians per second.
constexpr int kMostSamples = 256;
constexpr double kDividerStep = 0.05;  // Of the columns.
constexpr double kExposureStep = 0.25;

/// The entry after (or before) a value in a list, around its ends.
std::string Neighbor(const std::vector<std::string>& list,
                     const std::string& value, int step) {
  if (list.empty()) return value;
  const auto count = static_cast<std::ptrdiff_t>(list.size());
  const auto found = std::ranges::find(list, value);
  if (found == list.end()) return step > 0 ? list.front() : list.back();
  const std::ptrdiff_t at = found - list.begin() + step + count;
  return list[static_cast<std::size_t>(at % count)];
}

const char* OnOff(bool on) { return on ? " on" : " off"; }

}  // namespace

LiveState::LiveState(LiveView view, LiveChoices choices)
    : view_(std::move(view)),
      choices_(std::move(choices)),
      last_scene_(view_.scene),
      terminal_depth_(view_.depth),
      split_(view_.split) {
  for (std::string& spec : view_.encoders) {
    if (spec.empty()) spec = view_.encoders[0];
    if (std::ranges::find(choices_.encoders, spec) == choices_.encoders.end()) {
      choices_.encoders.insert(choices_.encoders.begin(), spec);
    }
  }
}

void LiveState::Apply(LiveCommand command) {
  switch (command) {
    case LiveCommand::kHelp:
      modes_.help = !modes_.help;
      break;
    case LiveCommand::kPanel:
      modes_.panel = !modes_.panel;
      Arrange();
      break;
    case LiveCommand::kSplit:
      Split();
      break;
    case LiveCommand::kDividerLeft:
      MoveDivider(divider_ - kDividerStep);
      break;
    case LiveCommand::kDividerRight:
      MoveDivider(divider_ + kDividerStep);
      break;
    case LiveCommand::kSwapSides:
      modes_.side = split_ ? 1 - modes_.side : 0;
      break;
    case LiveCommand::kScenePicker:
      modes_.picker = true;
      modes_.help = false;
      break;
    case LiveCommand::kQuality:
      modes_.quality = !modes_.quality;
      break;
    case LiveCommand::kGovernor:
      modes_.governor = !modes_.governor;
      Log(std::string("governor") + OnOff(modes_.governor));
      break;
    case LiveCommand::kClose:
      modes_.help = false;
      break;
    default:
      ApplyToView(command);
  }
}

void LiveState::ApplyToView(LiveCommand command) {
  switch (command) {
    case LiveCommand::kNextEncoder:
      return ChangeEncoder(1);
    case LiveCommand::kPreviousEncoder:
      return ChangeEncoder(-1);
    case LiveCommand::kIntegrator:
      view_.integrator = view_.integrator == "path" ? "whitted" : "path";
      return Log("integrator " + view_.integrator);
    case LiveCommand::kMoreSamples:
      return ChangeSamples(true);
    case LiveCommand::kFewerSamples:
      return ChangeSamples(false);
    case LiveCommand::kBackend:
      return NextBackend();
    case LiveCommand::kBrighter:
      return ChangeExposure(kExposureStep);
    case LiveCommand::kDarker:
      return ChangeExposure(-kExposureStep);
    case LiveCommand::kColorDepth:
      return ChangeDepth();
    case LiveCommand::kTemporal:
      view_.temporal = !view_.temporal;
      return Log(std::string("temporal stability") + OnOff(view_.temporal));
    case LiveCommand::kReset:
      return Reset();
    default:
      ApplyToMovement(command);
  }
}

void LiveState::ApplyToMovement(LiveCommand command) {
  switch (command) {
    case LiveCommand::kPause:
      modes_.playing = !modes_.playing;
      return Log(modes_.playing ? "playing" : "paused");
    case LiveCommand::kStep:
      return StepOnce();
    case LiveCommand::kOrbit:
      modes_.orbit = !modes_.orbit && Camera() != nullptr;
      return;
    default:
      actions_.push_back(command);  // Not the state's.
  }
}

void LiveState::ChangeEncoder(int step) {
  std::string& spec = view_.encoders[split_ ? modes_.side : 0];
  spec = Neighbor(choices_.encoders, spec, step);
  Log("encoder " + spec);
}

void LiveState::ChangeSamples(bool more) {
  view_.spp = std::clamp(more ? view_.spp * 2 : view_.spp / 2, 1, kMostSamples);
  Log(std::to_string(view_.spp) + " rays per sample");
}

void LiveState::ChangeExposure(double stops) {
  const double base = scene_ ? scene_->settings.exposure : 0;
  view_.exposure =
      std::clamp(view_.exposure.value_or(base) + stops, -64.0, 64.0);
}

void LiveState::ChangeDepth() {
  const int fewest = static_cast<int>(ColorDepth::kMono);
  const int next = static_cast<int>(view_.depth) + 1;
  view_.depth = next > fewest ? terminal_depth_ : static_cast<ColorDepth>(next);
  Log(std::string("colors: ") + NameOf(view_.depth));
}

void LiveState::NextBackend() {
  view_.backend = Neighbor(choices_.backends, view_.backend, 1);
  Log("backend " + view_.backend);
}

void LiveState::StepOnce() {
  modes_.playing = false;
  if (animated()) view_.time = std::min(view_.time + kStepSeconds, kLatest);
}

void LiveState::Reset() {
  camera_.reset();
  view_.camera.reset();
  view_.exposure.reset();
  view_.time = 0;
  modes_.orbit = false;
  orbit_angle_ = 0;
  divider_ = 0.5;
  held_.Clear();
  Arrange();
}

void LiveState::Split() {
  split_ = !split_;
  modes_.side = split_ ? 1 : 0;
  if (split_ && view_.encoders[0] == view_.encoders[1]) ChangeEncoder(1);
  Arrange();
}

void LiveState::MoveDivider(double share) {
  divider_ = std::clamp(share, 0.02, 0.98);
  Arrange();
}

void LiveState::Resize(GridSize terminal) {
  terminal_ = terminal;
  Arrange();
}

void LiveState::Arrange() {
  layout_ = MakeLayout(terminal_, modes_.panel);
  view_.grid = {layout_.picture.columns, layout_.picture.rows};
  view_.split = split_ && view_.grid.columns > 1;
  if (!view_.split) {
    view_.divider = 0;
    return;
  }
  view_.divider =
      std::clamp(static_cast<int>(std::lround(divider_ * view_.grid.columns)),
                 1, view_.grid.columns - 1);
}

void LiveState::Adopt(std::shared_ptr<const Scene> scene) {
  const bool same = scene_ && scene_->file == scene->file;
  scene_ = std::move(scene);
  last_scene_ = view_.scene;
  if (same) return;  // Another backend.
  speed_ = SceneSpeed(*scene_);
  camera_.reset();
  view_.camera.reset();
  for (const std::string& warning : scene_->warnings) Log(warning);
}

void LiveState::RejectScene() { view_.scene = last_scene_; }

void LiveState::set_terminal_depth(ColorDepth depth) {
  terminal_depth_ = depth;
  view_.depth = depth;
}

FreeCamera* LiveState::Camera() {
  if (camera_) return &*camera_;
  if (!scene_ || !scene_->camera.user_control) {
    if (scene_) Log("the camera of this scene does not move");
    return nullptr;
  }
  camera_.emplace(CameraAt(*scene_, view_.time), scene_->camera.up, speed_);
  return &*camera_;
}

bool LiveState::animated() const { return scene_ && !scene_->paths.empty(); }

bool LiveState::moving(double now) const {
  return (modes_.playing && animated()) || modes_.orbit ||
         held_.At(now).any() || (camera_ && camera_->moving());
}

void LiveState::Step(double now, double seconds) {
  if (modes_.playing && animated()) {
    view_.time = std::min(view_.time + seconds, kLatest);
  }
  if (modes_.orbit && scene_) Orbit(seconds);
  const MotionInput input = held_.At(now);
  if (camera_ && (input.any() || camera_->moving())) {
    camera_->Step(input, seconds);
  }
  if (camera_) view_.camera = camera_->frame();
}

void LiveState::Orbit(double seconds) {
  const double ahead =
      (scene_->camera.look_at - scene_->camera.position).length();
  const double distance = scene_->camera.has_look_at ? ahead : 3 * speed_;
  FreeCamera* camera = Camera();
  if (camera == nullptr) return;
  const double angle = orbit_side_ * kOrbitSpeed * seconds;
  camera->Orbit(angle, distance);
  orbit_angle_ += angle;
  if (orbit_angle_ * orbit_side_ >= modes_.orbit_reach) {
    orbit_side_ = -orbit_side_;
  }
}

std::vector<LiveCommand> LiveState::TakeActions() {
  return std::exchange(actions_, {});
}

void LiveState::Log(const std::string& message) {
  log_.push_back(Printable(message));
  if (log_.size() > kLogLines) log_.pop_front();
}

}  // namespace rtb
