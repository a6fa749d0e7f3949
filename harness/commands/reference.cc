#include <string>

#include "harness/commands/command.h"
#include "harness/commands/console.h"
#include "harness/commands/options.h"
#include "harness/lookup.h"
#include "reference/povray.h"

namespace rtb {
namespace {

struct ReferenceOptions {
  std::string scene;
  std::string renderer;
  PixelSize size{960, 640};
  ReferenceRequest request;
  std::string output;
  bool quiet = false;
};

/// Only the canonical kind of image may replace a reference unasked.
Status CheckCanonical(const ReferenceRequest& request) {
  if (request.width == 960 && request.height == 640 && request.spp >= 64) {
    return {};
  }
  return Fail(BadInput("reference",
                       "without --output the scene's own reference would be "
                       "replaced, which is 960x640 with 64 or more rays",
                       "name another file with --output"));
}

Status WriteReference(const ReferenceOptions& options) {
  if (options.renderer == "cycles") {
    return Fail(Missing("--renderer", "this version cannot run Cycles",
                        "take --renderer=povray"));
  }
  RTB_ASSIGN_OR_RETURN(const PreparedScene scene,
                       LoadNamedScene(options.scene));
  ReferenceRequest request = options.request;
  request.width = options.size.width;
  request.height = options.size.height;
  request.output = options.output;
  if (request.output.empty()) {
    RTB_RETURN_IF_ERROR(CheckCanonical(request));
    request.output = ReferenceFile(scene.file, "povray", request.time);
  }
  RTB_RETURN_IF_ERROR(
      RenderPovReference(*scene.scene, request, ProgressLine(options.quiet)));
  if (!options.quiet) PrintNote("wrote " + request.output.string());
  return {};
}

void AddOptions(CLI::App& app, ReferenceOptions& options) {
  AddSceneName(app, options.scene);
  AddWord(app, {"--renderer", "povray", "", "povray: POV-Ray 3.7"},
          options.renderer, {"povray", "cycles"})
      ->required();
  AddParsed(app, {"--size", "WxH", "960x640", "Pixels of the reference"},
            options.size, ParseImageSize);
  AddSpp(app, options.request.spp);
  AddTime(app, options.request.time);
  AddText(
      app,
      {"--output", "FILE",
       "reference/SCENE.povray.exr, or SCENE.tTIME.povray.exr",
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
