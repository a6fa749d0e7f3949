#include "harness/reference_choice.h"

#include <nlohmann/json.hpp>

#include "core/base/file.h"
#include "core/image/io.h"
#include "harness/lookup.h"
#include "harness/rasters.h"
#include "reference/pov_export.h"

namespace rtb {
namespace {

bool IsRenderer(const std::string& name) {
  return name == "povray" || name == "cycles";
}

/// Whether a reference's provenance says that it shows this scene: the same
/// file, or one that means the same to POV-Ray. Without provenance it is
/// believed.
bool Shows(const std::filesystem::path& reference, const Scene& scene) {
  const auto text = ReadFile(reference.string() + ".json");
  if (!text) return true;
  const auto provenance = nlohmann::json::parse(*text, nullptr, false);
  if (!provenance.is_object()) return false;
  using Pointer = nlohmann::json::json_pointer;
  const auto says = [&](const char* key, const std::string& sha256) {
    return provenance.value(Pointer(key), nlohmann::json()) == sha256;
  };
  if (says("/scene/sha256", scene.sha256)) return true;
  const auto exported = ExportPov(scene, 0);
  return exported && says("/sdl_sha256", Sha256(*exported));
}

std::string DefaultChoice(const PreparedScene& scene) {
  if (scene.options.time != 0) return "self";
  for (const char* renderer : {"povray", "cycles"}) {
    const auto file = FindReference(scene.file, renderer);
    if (file && Shows(*file, *scene.scene)) return renderer;
  }
  return "self";
}

/// The scene's own depth and no seed: the picture that is to be approached
/// does not change with the options of a run.
Result<ReferencePicture> RenderSelf(const PreparedScene& scene,
                                    PixelSize raster) {
  RenderOptions options;
  options.time = scene.options.time;
  options.threads = scene.options.threads;
  options.integrator = scene.options.integrator;
  options.spp = kSelfReferenceSpp;
  RTB_ASSIGN_OR_RETURN(const Image linear,
                       RenderImage(*scene.backend, raster, options));
  return ReferencePicture{
      DisplayEncoded(linear, scene.exposure, true), "self", {}};
}

Result<std::filesystem::path> CommittedFile(const std::string& renderer,
                                            const PreparedScene& scene) {
  if (scene.options.time != 0) {
    return Fail(BadInput("--reference",
                         "the " + renderer + " reference shows time 0 only",
                         "take --reference=self, or --time=0"));
  }
  const auto file = FindReference(scene.file, renderer);
  if (file && Shows(*file, *scene.scene)) return *file;
  return Fail(BadInput(
      "--reference",
      file ? file->string() + " shows another version of this scene"
           : "this scene has no " + renderer + " reference",
      renderer == "povray"
          ? "render it with `rtbench reference --renderer=povray`, or take "
            "--reference=self"
          : "take --reference=self"));
}

}  // namespace

Result<ReferencePicture> ChooseReference(const std::string& choice,
                                         const PreparedScene& scene,
                                         PixelSize raster) {
  const std::string name = choice.empty() ? DefaultChoice(scene) : choice;
  if (name == "self") return RenderSelf(scene, raster);
  ReferencePicture picture;
  picture.name = name;
  picture.file = name;
  if (IsRenderer(name)) {
    RTB_ASSIGN_OR_RETURN(picture.file, CommittedFile(name, scene));
  } else {
    picture.name = picture.file.filename().string();
  }
  RTB_ASSIGN_OR_RETURN(picture.display,
                       ReadDisplayed(picture.file, scene.exposure));
  Status same =
      CheckAspects({picture.display.width(), picture.display.height()}, raster,
                   "--reference");
  if (same) return picture;
  same.error().hint = "--reference=self renders the reference for any grid";
  return Fail(std::move(same.error()));
}

}  // namespace rtb
