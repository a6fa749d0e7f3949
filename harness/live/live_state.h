/// @file
/// LiveState: what a person has chosen, and what keys and mouse make of it.
/// Knows no terminal and no clock.
#pragma once

#include <deque>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/scene/scene.h"
#include "harness/live/command.h"
#include "harness/live/free_camera.h"
#include "harness/live/held_keys.h"
#include "harness/live/layout.h"
#include "harness/live/live_view.h"

namespace rtb {

/// What can be chosen.
struct LiveChoices {
  std::vector<std::string> encoders;  ///< SPECs.
  std::vector<std::string> scenes;    ///< Names.
  std::vector<std::string> backends;  ///< Those that run here.
};

/// What is on the screen beside the picture, and what goes on.
struct LiveModes {
  bool panel = true;
  bool help = false;
  bool picker = false;
  std::size_t picked = 0;  ///< Scene that the picker points at.
  bool playing = true;     ///< Movement paths run.
  bool orbit = false;
  /// Where the orbit turns back, to each side, in radians.
  double orbit_reach = std::numeric_limits<double>::infinity();
  bool governor = true;
  bool quality = false;
  std::size_t side = 0;  ///< The split screen's side that `n` changes.
};

/// The state of a session.
class LiveState {
 public:
  LiveState(LiveView view, LiveChoices choices);

  /// A key or the mouse, at that many seconds.
  void Handle(const InputEvent& event, double now);
  /// What a key does.
  void Apply(LiveCommand command);
  /// Goes on by `seconds`: camera and movement.
  void Step(double now, double seconds);

  /// The terminal has this size.
  void Resize(GridSize terminal);
  /// Width / height of a cell.
  void set_cell_aspect(double aspect) { view_.cell_aspect = aspect; }
  /// The view's scene has been loaded.
  void Adopt(std::shared_ptr<const Scene> scene);
  /// It could not be: back to the one before.
  void RejectScene();
  /// Whether key-up events come.
  void set_key_releases(bool releases) { held_.set_releases(releases); }
  /// The terminal's colors; fewer may be chosen.
  void set_terminal_depth(ColorDepth depth);
  /// Lets go of all keys.
  void ReleaseKeys() { held_.Clear(); }

  const LiveView& view() const { return view_; }
  LiveModes& modes() { return modes_; }
  const LiveModes& modes() const { return modes_; }
  const LiveChoices& choices() const { return choices_; }
  const Layout& layout() const { return layout_; }
  GridSize terminal() const { return terminal_; }
  /// Whether something moves, so that every picture is another.
  bool moving(double now) const;
  /// Whether the scene has movement paths.
  bool animated() const;

  /// Commands that are not the state's: screenshot, recording, redraw, quit.
  std::vector<LiveCommand> TakeActions();

  /// Appends to the log; escape sequences are made visible.
  void Log(const std::string& message);
  const std::deque<std::string>& log() const { return log_; }

 private:
  void ApplyToView(LiveCommand command);
  void ApplyToMovement(LiveCommand command);
  void HandleKey(const KeyEvent& key, double now);
  void HandlePicker(const KeyEvent& key);
  void HandleMouse(const MouseEvent& mouse);
  void ChangeEncoder(int step);
  void ChangeSamples(bool more);
  void ChangeExposure(double stops);
  void ChangeDepth();
  void NextBackend();
  void StepOnce();
  void Orbit(double seconds);
  void Reset();
  void Split();
  void MoveDivider(double share);
  void Arrange();
  /// The camera that moves; nullptr where the scene forbids it.
  FreeCamera* Camera();

  LiveView view_;
  LiveChoices choices_;
  LiveModes modes_;
  HeldKeys held_;
  std::optional<FreeCamera> camera_;
  double orbit_angle_ = 0;  ///< From where the orbit began.
  double orbit_side_ = 1;   ///< The way it goes, 1 or -1.
  std::shared_ptr<const Scene> scene_;
  std::string last_scene_;  ///< The one that was loaded.
  double speed_ = 1;
  ColorDepth terminal_depth_ = ColorDepth::kTruecolor;
  GridSize terminal_{80, 24};
  Layout layout_;
  bool split_ = false;    ///< Wanted; a single column cannot be split.
  double divider_ = 0.5;  ///< Share of the columns.
  bool dragging_divider_ = false;
  std::optional<MouseEvent> mouse_;  ///< Where a drag was last.
  std::vector<LiveCommand> actions_;
  std::deque<std::string> log_;
};

}  // namespace rtb
