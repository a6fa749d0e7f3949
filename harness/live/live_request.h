/// @file
/// LiveRequest: what a user of `live` asks for.
#pragma once

#include <optional>
#include <string>

#include "encoders/color_depth.h"
#include "harness/prepared_scene.h"

namespace rtb {

/// How a terminal is drawn on.
enum class PresentMode {
  kAuto,     ///< Direct where 24-bit color is sure, else ncurses.
  kDirect,   ///< Escape sequences of our own.
  kNcurses,  ///< ncurses.
  kString,   ///< As direct, into memory; without a terminal alone.
};

/// How the picture moves when nobody steers it.
enum class HeadlessMotion {
  kSway,   ///< The camera swings to and fro around what it looks at: every
           ///< picture shows about the same.
  kOrbit,  ///< It goes all around that, through walls if need be.
  kPath,   ///< The scene's own movement.
  kStill,  ///< Nothing moves.
};

/// The options of `live`.
struct LiveRequest {
  SceneRequest scene;  ///< Its exposure is where the session begins.
  std::string encoder = "quadrant";  ///< One SPEC, or two for a split screen.
  std::optional<ColorDepth> depth;   ///< None: what the terminal has.
  double target_fps = 60;            ///< 0: no governor.
  PresentMode present = PresentMode::kAuto;
  std::string record;  ///< File; empty: none.
  bool sync = true;
  bool keys = true;        ///< kitty's, where the terminal has them.
  bool no_color = false;   ///< The environment asks for none.
  std::string term;        ///< TERM.
  std::string color_term;  ///< COLORTERM.

  /// @name Without a terminal.
  /// @{
  GridSize grid{120, 40};
  int frames = 300;
  int warmup = 20;  ///< Pictures before those that are measured.
  HeadlessMotion motion = HeadlessMotion::kSway;
  bool panel = false;
  /// @}
};

}  // namespace rtb
