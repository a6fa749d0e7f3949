#include "reference/cycles.h"

#include <nlohmann/json.hpp>
#include <system_error>
#include <vector>

#include "core/base/file.h"
#include "core/base/manifest.h"
#include "core/base/process.h"
#include "reference/blender_export.h"
#include "reference/cycles_passes.h"
#include "reference/work_folder.h"

namespace rtb {
namespace {

/// `Blender 3.4.1`, as the program says it.
Result<std::string> BlenderVersion() {
  if (!FindProgram("blender")) {
    return Fail(Missing("blender", "the program is not on PATH",
                        "apt-get install blender"));
  }
  RTB_ASSIGN_OR_RETURN(const ProcessResult said,
                       RunProcess({{"blender", "--version"}, {}, 60}));
  const std::size_t at = said.out.find("Blender ");
  if (at == std::string::npos) {
    return Fail(Missing("blender", "it does not tell its version",
                        "Blender 3.4 is needed: apt-get install blender"));
  }
  return said.out.substr(at, said.out.find('\n', at) - at);
}

Status CheckRequest(const ReferenceRequest& request) {
  if (request.width < 1 || request.height < 1) {
    return Fail(BadInput("--size",
                         std::to_string(request.width) + "x" +
                             std::to_string(request.height) + " is no size",
                         "both numbers must be positive"));
  }
  if (request.spp < 1 || request.spp > kCyclesPassSpp * 1024) {
    return Fail(BadInput("--spp", std::to_string(request.spp) +
                                      " rays per pixel, expected 1 to " +
                                      std::to_string(kCyclesPassSpp * 1024)));
  }
  if (request.seed < 0 || request.seed > kMaxCyclesSeed) {
    return Fail(BadInput("--seed", std::to_string(request.seed) +
                                       ", expected 0 to " +
                                       std::to_string(kMaxCyclesSeed)));
  }
  return {};
}

/// What is rendered, besides the request.
struct Job {
  std::string version;
  std::string json;
  std::vector<WorkFile> scripts;

  std::string ScriptHash() const {
    std::string all;
    for (const WorkFile& script : scripts) all += Sha256(script.bytes);
    return Sha256(all);
  }
};

/// What the passes in a work folder depend on. Not on the number of samples:
/// passes of a smaller request serve a larger one, but for the last of them,
/// whose name says its samples.
std::string RequestHash(const Job& job, const ReferenceRequest& request) {
  return Sha256(Sha256(job.json) + "\n" + job.ScriptHash() + "\n" +
                job.version + "\n" + std::to_string(request.width) + "x" +
                std::to_string(request.height) + "\n" +
                std::to_string(request.seed) + "\n" +
                (request.pixel_centers ? "centers" : "box"));
}

/// A picture and what it took.
struct Rendering {
  Image image;
  double seconds = 0;
  std::size_t passes = 0;
  std::vector<std::string> first_command;
};

Result<Rendering> RenderPasses(const CyclesPassRenderer& renderer,
                               const ReferenceRequest& request,
                               const Progress& progress) {
  const std::vector<CyclesPass> passes = PassesOf(request);
  Rendering rendering;
  rendering.passes = passes.size();
  rendering.first_command = renderer.Command(passes.front());
  ImageMean mean(request.width, request.height);
  const std::string count = std::to_string(passes.size());
  for (const CyclesPass& pass : passes) {
    if (progress) {
      progress(
          static_cast<double>(pass.index) / static_cast<double>(passes.size()),
          "pass " + std::to_string(pass.index + 1) + " of " + count);
    }
    RTB_ASSIGN_OR_RETURN(const double seconds, renderer.Render(pass));
    rendering.seconds += seconds;
    RTB_ASSIGN_OR_RETURN(const Image image, renderer.Read(pass));
    mean.Add(image, pass.spp);
  }
  if (progress) progress(1, "done");
  rendering.image = mean.Take();
  return rendering;
}

nlohmann::ordered_json Provenance(const Scene& scene,
                                  const ReferenceRequest& request,
                                  const Job& job, const Rendering& rendering) {
  return {
      {"schema", kProvenanceSchema},
      {"renderer", "cycles"},
      {"version", job.version},
      {"scene", {{"name", scene.name}, {"sha256", scene.sha256}}},
      {"export_sha256", Sha256(job.json)},
      {"script_sha256", job.ScriptHash()},
      {"settings",
       {{"width", request.width},
        {"height", request.height},
        {"spp", request.spp},
        {"time", request.time},
        {"seed", request.seed},
        {"integrator", request.integrator},
        {"max_depth", scene.settings.max_depth},
        {"filter", request.pixel_centers
                       ? "every ray through its pixel's center"
                       : "box over the pixel, linear light"}}},
      {"command", JoinedWords(rendering.first_command)},
      {"passes", rendering.passes},
      {"date", UtcNow()},
      {"wall_seconds", rendering.seconds},
  };
}

}  // namespace

Status RenderCyclesReference(const Scene& scene,
                             const ReferenceRequest& request,
                             const Progress& progress) {
  RTB_RETURN_IF_ERROR(CheckRequest(request));
  Job job;
  RTB_ASSIGN_OR_RETURN(job.json,
                       ExportBlender(scene, request.time, request.integrator));
  RTB_ASSIGN_OR_RETURN(job.version, BlenderVersion());
  job.scripts = BlenderScripts();
  std::vector<WorkFile> files = job.scripts;
  files.push_back({"scene.json", job.json});
  const std::filesystem::path folder = request.output.string() + ".work";
  RTB_RETURN_IF_ERROR(
      PrepareWorkFolder(folder, RequestHash(job, request), files));
  RTB_ASSIGN_OR_RETURN(
      const Rendering rendering,
      RenderPasses(CyclesPassRenderer(folder, request), request, progress));
  RTB_RETURN_IF_ERROR(WriteReference(rendering.image,
                                     Provenance(scene, request, job, rendering),
                                     request.output));
  std::error_code ignored;  // A left-over folder does no harm.
  std::filesystem::remove_all(folder, ignored);
  return {};
}

}  // namespace rtb
