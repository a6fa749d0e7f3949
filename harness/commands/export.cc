#include <string>

#include "harness/commands/command.h"
#include "harness/commands/console.h"
#include "harness/commands/options.h"
#include "reference/pov_export.h"

namespace rtb {
namespace {

struct ExportOptions {
  std::string scene;
  std::string format;
  double time = 0;
  std::string output = "-";
};

Status Export(const ExportOptions& options) {
  RTB_ASSIGN_OR_RETURN(const PreparedScene scene,
                       LoadNamedScene(options.scene));
  RTB_ASSIGN_OR_RETURN(const std::string text,
                       ExportPov(*scene.scene, options.time));
  return WriteOutput(options.output, text);
}

void AddOptions(CLI::App& app, ExportOptions& options) {
  AddSceneName(app, options.scene);
  AddWord(app, {"--format", "pov", "", "pov: POV-Ray 3.7"}, options.format,
          {"pov"})
      ->required();
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
