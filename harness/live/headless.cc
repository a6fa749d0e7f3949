#include "harness/live/headless.h"

#include <memory>

#include "harness/live/drained_pty.h"
#include "harness/live/live_loop.h"
#include "harness/live/live_setup.h"

namespace rtb {
namespace {

FramePercentiles PercentilesOf(const std::vector<double>& values) {
  return {Percentile(values, 0.5), Percentile(values, 0.95),
          Percentile(values, 0.99)};
}

Json ToJson(const FramePercentiles& values) {
  return {{"p50", values.p50}, {"p95", values.p95}, {"p99", values.p99}};
}

LoopOptions OptionsOf(const LiveRequest& request, ColorDepth depth) {
  LoopOptions options;
  options.target_fps = request.target_fps;
  options.paced = false;
  options.frames = request.frames;
  options.warmup = request.warmup;
  options.step_seconds = 1.0 / 60;
  options.sync = request.sync;
  options.depth = depth;
  options.color_reason = "forced";
  return options;
}

void Steer(HeadlessMotion motion, LiveState* state) {
  constexpr double kSwayReach = 0.2;  // Radians.
  LiveModes& modes = state->modes();
  modes.orbit =
      motion == HeadlessMotion::kSway || motion == HeadlessMotion::kOrbit;
  if (motion == HeadlessMotion::kSway) modes.orbit_reach = kSwayReach;
  state->modes().playing = motion != HeadlessMotion::kStill;
}

LiveFigures FiguresOf(const LiveRequest& request, const LiveLoop& loop,
                      const LiveView& view) {
  const LoopTotals& totals = loop.totals();
  LiveFigures figures;
  const double frames = std::max(totals.frames, 1);
  figures.fps = totals.seconds > 0 ? (totals.frames - 1) / totals.seconds : 0;
  figures.frame_ms = PercentilesOf(totals.intervals_ms);
  figures.draw_ms = PercentilesOf(totals.draw_ms);
  figures.render_ms = totals.render_ms / frames;
  figures.encode_ms = totals.encode_ms / frames;
  figures.bytes_per_frame = totals.bytes / frames;
  figures.cells_per_frame = totals.cells / frames;
  figures.differing_cells_per_frame = totals.differ / frames;
  figures.cpu_ms_per_frame = totals.cpu_ms / frames;
  figures.rays_per_cell = totals.eye_rays_per_cell / frames;
  figures.encoder = request.encoder;
  figures.scene = request.scene.scene;
  figures.backend = view.backend;
  figures.integrator = view.integrator;
  figures.motion = NameOf(request.motion);
  figures.color = NameOf(view.depth);
  figures.grid = request.grid;
  figures.frames = totals.frames;
  figures.warmup = request.warmup;
  figures.target_fps = request.target_fps;
  return figures;
}

}  // namespace

const char* NameOf(HeadlessMotion motion) {
  switch (motion) {
    case HeadlessMotion::kPath:
      return "path";
    case HeadlessMotion::kStill:
      return "still";
    case HeadlessMotion::kOrbit:
      return "orbit";
    case HeadlessMotion::kSway:
      break;
  }
  return "sway";
}

Result<LiveFigures> RunHeadless(const LiveRequest& given) {
  LiveRequest request = given;
  if (request.present == PresentMode::kAuto) {
    request.present = PresentMode::kDirect;
  }
  UseUtf8Locale();
  const ColorDepth depth = request.depth.value_or(ColorDepth::kTruecolor);
  RTB_ASSIGN_OR_RETURN(LiveState state, MakeLiveState(request));
  state.modes().panel = request.panel;
  state.set_terminal_depth(depth);
  Steer(request.motion, &state);
  RTB_ASSIGN_OR_RETURN(const auto presenter,
                       MakePresenter(request, depth, request.grid));
  LoopOptions options = OptionsOf(request, depth);
  LoopTerminal terminal;
  terminal.presenter = presenter.get();
  terminal.size = [&request] { return request.grid; };
  terminal.cell_aspect = [] { return 0.5; };
  std::unique_ptr<DrainedPty> pty;
  OutputQueue memory([](std::string_view) {});
  terminal.output = &memory;
  if (request.present != PresentMode::kString) {
    RTB_ASSIGN_OR_RETURN(pty, DrainedPty::Open(request.grid));
    terminal.input = pty->fd();
    options.fence = true;
  }
  OutputQueue queue(pty ? pty->fd() : -1);
  if (pty) terminal.output = &queue;
  const WakePipe wake;
  LiveLoop loop(std::move(state), options, terminal, wake);
  if (!request.record.empty()) {
    RTB_RETURN_IF_ERROR(loop.StartRecording(request.record));
  }
  RTB_RETURN_IF_ERROR(loop.Run());
  LiveFigures figures = FiguresOf(request, loop, loop.state().view());
  figures.present = pty ? std::string(presenter->name()) + ", pseudo terminal"
                        : "string, memory";
  return figures;
}

Json FiguresToJson(const LiveFigures& figures) {
  return {{"schema", kRecordSchema},
          {"fps", figures.fps},
          {"frame_ms", ToJson(figures.frame_ms)},
          {"draw_ms", ToJson(figures.draw_ms)},
          {"render_ms", figures.render_ms},
          {"encode_ms", figures.encode_ms},
          {"bytes_per_frame", figures.bytes_per_frame},
          {"cells_per_frame", figures.cells_per_frame},
          {"differing_cells_per_frame", figures.differing_cells_per_frame},
          {"rays_per_cell", figures.rays_per_cell},
          {"cpu_ms_per_frame", figures.cpu_ms_per_frame},
          {"present", figures.present},
          {"encoder", figures.encoder},
          {"scene", figures.scene},
          {"grid", Json::array({figures.grid.columns, figures.grid.rows})},
          {"backend", figures.backend},
          {"integrator", figures.integrator},
          {"motion", figures.motion},
          {"color", figures.color},
          {"frames", figures.frames},
          {"warmup", figures.warmup},
          {"target_fps", figures.target_fps}};
}

}  // namespace rtb
