#include "reference/povray.h"

#include <nlohmann/json.hpp>
#include <system_error>
#include <vector>

#include "core/base/file.h"
#include "core/base/manifest.h"
#include "core/base/process.h"
#include "reference/pov_export.h"
#include "reference/pov_passes.h"
#include "reference/work_folder.h"

namespace rtb {
namespace {

/// `POV-Ray 3.7.0.10`, from the lines that the program greets with.
Result<std::string> PovVersion() {
  if (!FindProgram("povray")) {
    return Fail(Missing("povray", "the program is not on PATH",
                        "apt-get install povray"));
  }
  RTB_ASSIGN_OR_RETURN(const ProcessResult said,
                       RunProcess({{"povray", "--version"}, {}, 60}));
  const std::string text = "\n" + said.out + "\n" + said.err;
  const std::size_t at = text.find("\nPOV-Ray ");
  if (at == std::string::npos) {
    return Fail(Missing("povray", "it does not tell its version",
                        "POV-Ray 3.7 is needed: apt-get install povray"));
  }
  return text.substr(at + 1, text.find('\n', at + 1) - at - 1);
}

/// What the passes in a work folder depend on.
std::string RequestHash(const std::string& sdl, const std::string& version,
                        const ReferenceRequest& request) {
  return Sha256(
      Sha256(sdl) + "\n" + version + "\n" + std::to_string(request.width) +
      "x" + std::to_string(request.height) + "\n" +
      std::to_string(request.spp) + "x" + std::to_string(request.emitters));
}

/// Adds up images and gives their mean.
class MeanImage {
 public:
  void Add(const Image& image) {
    sums_.resize(image.pixels().size(), V3d(0));
    for (std::size_t i = 0; i < sums_.size(); ++i) {
      sums_[i] += V3d(image.pixels()[i]);
    }
    ++count_;
  }
  Image Mean(int width, int height) const {
    Image mean(width, height);
    for (std::size_t i = 0; i < sums_.size(); ++i) {
      mean.pixels()[i] = Rgb(sums_[i] / count_);
    }
    return mean;
  }

 private:
  std::vector<V3d> sums_;
  double count_ = 0;
};

/// A picture and what it took.
struct Rendering {
  Image image;
  double seconds = 0;
  std::vector<std::string> first_command;
  std::size_t passes = 0;
};

Result<Rendering> RenderPasses(const PovPassRenderer& renderer,
                               const ReferenceRequest& request, int side,
                               const Progress& progress) {
  const std::vector<PovPass> passes = PassesOf(side);
  Rendering rendering;
  rendering.first_command = renderer.Command(passes.front());
  rendering.passes = passes.size();
  MeanImage mean;
  for (std::size_t i = 0; i < passes.size(); ++i) {
    const double share =
        static_cast<double>(i) / static_cast<double>(passes.size());
    if (progress) {
      progress(share, "pass " + std::to_string(i + 1) + " of " +
                          std::to_string(passes.size()));
    }
    RTB_ASSIGN_OR_RETURN(const double seconds, renderer.Render(passes[i]));
    rendering.seconds += seconds;
    RTB_ASSIGN_OR_RETURN(const Image pass, renderer.Read(passes[i]));
    mean.Add(pass);
  }
  rendering.image = mean.Mean(request.width, request.height);
  if (progress) progress(1, "done");
  return rendering;
}

/// How area lights are sampled; nothing where there are none.
nlohmann::ordered_json AreaLightSettings(const Scene& scene,
                                         const ReferenceRequest& request) {
  int quads = 0, spheres = 0;
  for (const Light& light : scene.lights) {
    quads += std::holds_alternative<QuadLight>(light.kind);
    spheres += std::holds_alternative<SphereLight>(light.kind);
  }
  nlohmann::ordered_json settings;
  const char* each = " fixed cosine emitters a ray, others in each pass";
  if (quads > 0) {
    settings["quad_lights"] = std::to_string(request.emitters) + each;
  }
  if (spheres > 0) {
    settings["sphere_lights"] = std::to_string(2 * request.emitters) + each;
  }
  return settings;
}

nlohmann::ordered_json Provenance(const Scene& scene,
                                  const ReferenceRequest& request,
                                  const std::string& version,
                                  const std::string& sdl,
                                  const Rendering& rendering) {
  nlohmann::ordered_json provenance = {
      {"schema", kProvenanceSchema},
      {"renderer", "povray"},
      {"version", version},
      {"scene", {{"name", scene.name}, {"sha256", scene.sha256}}},
      {"sdl_sha256", Sha256(sdl)},
      {"settings",
       {{"width", request.width},
        {"height", request.height},
        {"spp", request.spp},
        {"time", request.time},
        {"max_depth", scene.settings.max_depth},
        {"filter", "mean of a regular grid of rays per pixel, linear light"}}},
      {"command", JoinedWords(rendering.first_command)},
      {"passes", rendering.passes},
      {"date", UtcNow()},
      {"wall_seconds", rendering.seconds},
  };
  const auto lights = AreaLightSettings(scene, request);
  if (!lights.is_null()) provenance["settings"].update(lights);
  return provenance;
}

}  // namespace

Status RenderPovReference(const Scene& scene, const ReferenceRequest& request,
                          const Progress& progress) {
  RTB_ASSIGN_OR_RETURN(const int side, GridSide(request));
  RTB_ASSIGN_OR_RETURN(const std::string version, PovVersion());
  RTB_ASSIGN_OR_RETURN(const std::string sdl, ExportPov(scene, request.time));
  const std::filesystem::path folder = request.output.string() + ".work";
  RTB_RETURN_IF_ERROR(PrepareWorkFolder(
      folder, RequestHash(sdl, version, request), {{"scene.pov", sdl}}));
  const PovPassRenderer renderer(folder, request, side);
  RTB_ASSIGN_OR_RETURN(const Rendering rendering,
                       RenderPasses(renderer, request, side, progress));
  RTB_RETURN_IF_ERROR(WriteReference(
      rendering.image, Provenance(scene, request, version, sdl, rendering),
      request.output));
  std::error_code ignored;  // A left-over folder does no harm.
  std::filesystem::remove_all(folder, ignored);
  return {};
}

}  // namespace rtb
