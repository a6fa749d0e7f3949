#include <string>

#include "harness/commands/command.h"
#include "harness/commands/console.h"
#include "harness/commands/options.h"
#include "harness/lookup.h"
#include "reference/cycles.h"
#include "reference/povray.h"

namespace rtb {
namespace {

constexpr int kMostEmitters = 4096;

struct ReferenceOptions {
  std::string scene;
  std::string renderer;
  PixelSize size{960, 640};
  int spp = 0;  ///< 0 = the renderer's default.
  ReferenceRequest request;
  std::string output;
  bool quiet = false;
};

/// Only the canonical kind of image may replace a reference unasked.
Status CheckCanonical(const ReferenceRequest& request, int least_spp) {
  if (request.width == 960 && request.height == 640 &&
      request.spp >= least_spp && request.integrator == "path") {
    return {};
  }
  return Fail(BadInput("reference",
                       "without --output the scene's own reference would be "
                       "replaced, which is 960x640 with " +
                           std::to_string(least_spp) + " or more rays",
                       "name another file with --output"));
}

Status WriteReference(const ReferenceOptions& options) {
  const bool cycles = options.renderer == "cycles";
  RTB_ASSIGN_OR_RETURN(const PreparedScene scene,
                       LoadNamedScene(options.scene));
  ReferenceRequest request = options.request;
  const int default_spp = cycles ? kCyclesSpp : request.spp;
  if (options.spp != 0 || cycles) {
    request.spp = options.spp != 0 ? options.spp : default_spp;
  }
  request.width = options.size.width;
  request.height = options.size.height;
  request.output = options.output;
  if (request.output.empty()) {
    RTB_RETURN_IF_ERROR(CheckCanonical(request, default_spp));
    request.output =
        ReferenceFile(scene.file, options.renderer, request.time, request.seed);
  }
  const auto render = cycles ? RenderCyclesReference : RenderPovReference;
  RTB_RETURN_IF_ERROR(
      render(*scene.scene, request, ProgressLine(options.quiet)));
  if (!options.quiet) PrintNote("wrote " + request.output.string());
  return {};
}

/// What Cycles alone can do.
void AddCyclesOptions(CLI::App& app, ReferenceRequest& request) {
  AddInteger(app,
             {"--seed", "N", "0",
              "cycles: another one gives another picture of other noise"},
             request.seed, 0, kMaxCyclesSeed);
  AddWord(app,
          {"--integrator", "path|whitted", request.integrator,
           "cycles: full light transport, or light from lamps alone"},
          request.integrator, {"path", "whitted"});
  app.add_flag("--pixel-centers", request.pixel_centers,
               "cycles: every ray goes through its pixel's center");
  app.add_flag("--nice", request.nice, "cycles: let other programs go first");
}

void AddOptions(CLI::App& app, ReferenceOptions& options) {
  AddSceneName(app, options.scene);
  AddWord(app,
          {"--renderer", "povray|cycles", "",
           "povray: POV-Ray 3.7; cycles: Blender 3.4"},
          options.renderer, {"povray", "cycles"})
      ->required();
  AddParsed(app, {"--size", "WxH", "960x640", "Pixels of the reference"},
            options.size, ParseImageSize);
  AddInteger(app,
             {"--spp", "N", "povray 64, cycles 1024",
              "Rays per pixel; POV-Ray takes a square number of them"},
             options.spp, 1, kCyclesPassSpp * 1024);
  AddTime(app, options.request.time);
  AddInteger(app,
             {"--emitters", "N", "34",
              "povray: points of an area light that each ray is lit by"},
             options.request.emitters, 1, kMostEmitters);
  AddCyclesOptions(app, options.request);
  AddText(
      app,
      {"--output", "FILE",
       "reference/SCENE.RENDERER.exr, or SCENE.tTIME.RENDERER.seedN.exr",
       "The EXR, by default beside the scenes; its provenance goes beside it"},
      options.output);
  AddQuiet(app, options.quiet);
}

}  // namespace

void AddReference(CLI::App& program, Action& selected) {
  AddCommand<ReferenceOptions>(program, selected, "reference",
                               "Renders a reference with another renderer",
                               AddOptions, WriteReference);
}

}  // namespace rtb
