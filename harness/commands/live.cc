#include "harness/live/live.h"

#include <csignal>
#include <cstdlib>

#include "harness/commands/command.h"
#include "harness/commands/console.h"
#include "harness/commands/options.h"
#include "harness/live/headless.h"

namespace rtb {
namespace {

struct LiveOptions {
  LiveRequest request;
  std::string color = "auto";
  std::string present = "auto";
  std::string motion = "sway";
  std::string json;
  bool headless = false;
  bool no_sync = false;
  bool no_keys = false;
  bool describe = false;
};

std::string Environment(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

/// The request, with what is said by words and by the environment.
LiveRequest RequestOf(const LiveOptions& options) {
  LiveRequest request = options.request;
  for (const ColorDepth depth : {ColorDepth::kTruecolor, ColorDepth::k256,
                                 ColorDepth::k16, ColorDepth::kMono}) {
    if (options.color == NameOf(depth)) request.depth = depth;
  }
  for (const HeadlessMotion motion :
       {HeadlessMotion::kOrbit, HeadlessMotion::kPath,
        HeadlessMotion::kStill}) {
    if (options.motion == NameOf(motion)) request.motion = motion;
  }
  if (options.present == "direct") request.present = PresentMode::kDirect;
  if (options.present == "ncurses") request.present = PresentMode::kNcurses;
  if (options.present == "string") request.present = PresentMode::kString;
  request.sync = !options.no_sync;
  request.keys = !options.no_keys;
  request.no_color = ColorsUnwanted();
  request.term = Environment("TERM");
  request.color_term = Environment("COLORTERM");
  return request;
}

std::string Summary(const LiveFigures& figures) {
  return std::to_string(figures.fps) + " frames/s, p50 " +
         std::to_string(figures.frame_ms.p50) + " ms, p99 " +
         std::to_string(figures.frame_ms.p99) + " ms, " +
         std::to_string(figures.bytes_per_frame) + " bytes a frame\n";
}

Status Measure(const LiveOptions& options) {
  RTB_ASSIGN_OR_RETURN(const LiveFigures figures,
                       RunHeadless(RequestOf(options)));
  if (options.json.empty()) return WriteOutput("-", Summary(figures));
  return WriteJson(options.json, FiguresToJson(figures));
}

Status Live(const LiveOptions& options) {
  if (options.describe) {
    RTB_ASSIGN_OR_RETURN(const std::string text,
                         DescribeTerminal(RequestOf(options)));
    return WriteOutput("-", text);
  }
  if (options.headless) return Measure(options);
  if (options.present == "string" || !options.json.empty()) {
    return Fail(
        BadInput("live", "--json and --present=string need --headless"));
  }
  RTB_ASSIGN_OR_RETURN(const int signal, RunLive(RequestOf(options)));
  if (signal == 0) return {};
  // Whoever started the program sees what ended it.
  std::signal(signal, SIG_DFL);
  std::raise(signal);
  return {};
}

void AddHeadlessOptions(CLI::App& app, LiveOptions& options) {
  app.add_flag("--headless", options.headless,
               "Measure without a person: as fast as it goes");
  AddInteger(app, {"--frames", "N", "300", "Pictures that are measured"},
             options.request.frames, 1, 1000000);
  AddInteger(app, {"--warmup", "N", "20", "Pictures before those"},
             options.request.warmup, 0, 1000000);
  AddWord(app, {"--motion", "sway|orbit|path|still", "sway", "What moves"},
          options.motion, {"sway", "orbit", "path", "still"});
  AddGrid(app, options.request.grid, "120x40");
  app.add_flag("--panel", options.request.panel, "With the info panel");
  AddJson(app, options.json);
}

void AddOptions(CLI::App& app, LiveOptions& options) {
  options.request.scene.scene = "whitted";
  AddSceneOptions(app, options.request.scene);
  AddText(
      app,
      {"--encoder", "SPEC[,SPEC]", "quadrant", "Encoder; two split the screen"},
      options.request.encoder);
  AddParsed(app,
            {"--target-fps", "N", "60",
             "Frames per second; 0 drops no rays for them"},
            options.request.target_fps,
            [](const std::string& place, const std::string& given) {
              return ParseNumber(place, given, 0, 1000);
            });
  AddWord(app,
          {"--color", "auto|truecolor|256|16|mono", "auto",
           "Colors of the terminal"},
          options.color, {"auto", "truecolor", "256", "16", "mono"});
  AddWord(app,
          {"--present", "auto|direct|ncurses|string", "auto",
           "What draws: our own sequences, or ncurses"},
          options.present, {"auto", "direct", "ncurses", "string"});
  AddText(app, {"--record", "FILE.cast", "", "Record as asciicast v2"},
          options.request.record);
  app.add_flag("--no-sync", options.no_sync, "No synchronized output");
  app.add_flag("--no-kitty-keys", options.no_keys, "No key-up events");
  app.add_flag("--term-caps", options.describe,
               "Print what the terminal can do, and exit");
  AddHeadlessOptions(app, options);
}

}  // namespace

void AddLive(CLI::App& program, Action& selected) {
  AddCommand<LiveOptions>(program, selected, "live",
                          "Draws a scene in this terminal, to walk through",
                          AddOptions, Live);
}

}  // namespace rtb
