#include <string>

#include "harness/commands/command.h"
#include "harness/commands/console.h"
#include "harness/commands/options.h"
#include "reference/blender_export.h"
#include "reference/pov_export.h"

namespace rtb {
namespace {

struct ExportOptions {
  std::string scene;
  std::string format;
  double time = 0;
  std::string integrator = "path";
  std::string output = "-";
};

Result<std::string> Exported(const Scene& scene, const ExportOptions& options) {
  if (options.format == "blender") {
    return ExportBlender(scene, options.time, options.integrator);
  }
  return ExportPov(scene, options.time);
}

Status Export(const ExportOptions& options) {
  RTB_ASSIGN_OR_RETURN(const PreparedScene scene,
                       LoadNamedScene(options.scene));
  RTB_ASSIGN_OR_RETURN(const std::string text, Exported(*scene.scene, options));
  return WriteOutput(options.output, text);
}

void AddOptions(CLI::App& app, ExportOptions& options) {
  AddSceneName(app, options.scene);
  AddWord(app,
          {"--format", "pov|blender", "",
           "pov: POV-Ray 3.7; blender: JSON for reference/blender/render.py"},
          options.format, {"pov", "blender"})
      ->required();
  AddWord(app,
          {"--integrator", "path|whitted", options.integrator,
           "How Blender is to transport light"},
          options.integrator, {"path", "whitted"});
  AddTime(app, options.time);
  AddText(app, {"--output", "FILE|-", "-", "Where to"}, options.output);
}

}  // namespace

void AddExport(CLI::App& program, Action& selected) {
  AddCommand<ExportOptions>(program, selected, "export",
                            "Writes a scene for another renderer", AddOptions,
                            Export);
}

}  // namespace rtb
