#include "reference/povray.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <system_error>
#include <vector>

#include "core/base/file.h"
#include "core/base/manifest.h"
#include "core/base/process.h"
#include "reference/pov_bands.h"
#include "reference/pov_export.h"
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

/// What the bands in a work folder depend on.
std::string RequestHash(const std::string& sdl, const std::string& version,
                        const ReferenceRequest& request) {
  return Sha256(Sha256(sdl) + "\n" + version + "\n" +
                std::to_string(request.width) + "x" +
                std::to_string(request.height) + "\n" +
                std::to_string(request.spp));
}

void CopyRows(const Image& rows, int first, Image* image) {
  for (int y = 0; y < rows.height(); ++y) {
    for (int x = 0; x < rows.width(); ++x) {
      image->at(x, first + y) = rows.at(x, y);
    }
  }
}

/// A picture and what it took.
struct Rendering {
  Image image;
  double seconds = 0;
  std::vector<std::string> first_command;
  std::size_t bands = 0;
};

Result<Rendering> RenderBands(const BandRenderer& renderer,
                              const ReferenceRequest& request,
                              const Progress& progress) {
  const std::vector<RowBand> bands = BandsOf(request);
  Rendering rendering;
  rendering.image = Image(request.width, request.height);
  rendering.first_command = renderer.Command(bands.front());
  rendering.bands = bands.size();
  for (std::size_t i = 0; i < bands.size(); ++i) {
    const double share =
        static_cast<double>(i) / static_cast<double>(bands.size());
    if (progress) {
      progress(share, "band " + std::to_string(i + 1) + " of " +
                          std::to_string(bands.size()));
    }
    RTB_ASSIGN_OR_RETURN(const double seconds, renderer.Render(bands[i]));
    rendering.seconds += seconds;
    RTB_ASSIGN_OR_RETURN(const Image rows, renderer.Averaged(bands[i]));
    CopyRows(rows, bands[i].begin, &rendering.image);
  }
  if (progress) progress(1, "done");
  return rendering;
}

nlohmann::ordered_json Provenance(const Scene& scene,
                                  const ReferenceRequest& request,
                                  const std::string& version,
                                  const std::string& sdl,
                                  const Rendering& rendering) {
  return {
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
      {"bands", rendering.bands},
      {"date", UtcNow()},
      {"wall_seconds", rendering.seconds},
  };
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
  const BandRenderer renderer(folder, request, side);
  RTB_ASSIGN_OR_RETURN(const Rendering rendering,
                       RenderBands(renderer, request, progress));
  RTB_RETURN_IF_ERROR(WriteReference(
      rendering.image, Provenance(scene, request, version, sdl, rendering),
      request.output));
  std::error_code ignored;  // A left-over folder does no harm.
  std::filesystem::remove_all(folder, ignored);
  return {};
}

}  // namespace rtb
