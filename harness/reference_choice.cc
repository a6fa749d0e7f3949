#include "harness/reference_choice.h"

#include "core/image/io.h"
#include "harness/lookup.h"
#include "harness/rasters.h"

namespace rtb {
namespace {

bool IsRenderer(const std::string& name) {
  return name == "povray" || name == "cycles";
}

std::string DefaultChoice(const PreparedScene& scene) {
  if (scene.options.time != 0) return "self";
  for (const char* renderer : {"povray", "cycles"}) {
    if (FindReference(scene.file, renderer)) return renderer;
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
  if (file) return *file;
  return Fail(BadInput(
      "--reference", "this scene has no " + renderer + " reference",
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
