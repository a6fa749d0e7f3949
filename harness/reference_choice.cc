#include "harness/reference_choice.h"

#include "core/image/io.h"
#include "harness/lookup.h"
#include "harness/measure/converged_image.h"
#include "harness/provenance.h"
#include "harness/rasters.h"

namespace rtb {
namespace {

bool IsRenderer(const std::string& name) {
  return name == "povray" || name == "cycles";
}

/// What is taken where nothing is asked for, and why.
struct DefaultReference {
  std::string name = "self";
  std::vector<std::string> notes;
};

/// Renderers whose images show what the integrator computes: POV-Ray's show
/// direct light and mirrors alone, as `whitted` does.
std::vector<const char*> RenderersFor(const std::string& integrator) {
  if (integrator == "path") return {"cycles"};
  return {"povray", "cycles"};
}

DefaultReference DefaultChoice(const PreparedScene& scene) {
  DefaultReference choice;
  for (const char* renderer : RenderersFor(scene.options.integrator)) {
    const auto file = FindReference(scene.file, renderer, scene.options.time);
    if (!file) continue;
    const Status fits =
        CheckProvenance(*file, renderer, *scene.scene, scene.options.time);
    if (fits) {
      choice.name = renderer;
      return choice;
    }
    choice.notes.push_back(fits.error().place + " " + fits.error().what +
                           ": it is not used");
  }
  choice.notes.push_back(
      "no reference image shows this scene at this time by this integrator: "
      "the reference is our own image");
  return choice;
}

Result<ReferencePicture> RenderSelf(const PreparedScene& scene,
                                    PixelSize raster,
                                    const std::filesystem::path& cache) {
  RTB_ASSIGN_OR_RETURN(
      const Image linear,
      ConvergedImage(scene, scene.options.time, raster, cache));
  return ReferencePicture{
      DisplayEncoded(linear, scene.exposure, true), "self", {}};
}

Result<std::filesystem::path> CommittedFile(const std::string& renderer,
                                            const PreparedScene& scene) {
  const std::filesystem::path file =
      ReferenceFile(scene.file, renderer, scene.options.time);
  const std::string hint =
      renderer == "povray"
          ? "render it with `rtbench reference --renderer=povray` at the same "
            "--time, or take --reference=self"
          : "take --reference=self";
  if (!FindReference(scene.file, renderer, scene.options.time)) {
    return Fail(BadInput("--reference",
                         "this scene has no " + renderer +
                             " reference at this time: there is no " +
                             file.string(),
                         hint));
  }
  const Status fits =
      CheckProvenance(file, renderer, *scene.scene, scene.options.time);
  if (fits) return file;
  return Fail(BadInput("--reference",
                       fits.error().place + " " + fits.error().what, hint));
}

}  // namespace

Result<ReferencePicture> ChooseReference(const std::string& choice,
                                         const PreparedScene& scene,
                                         PixelSize raster,
                                         const std::filesystem::path& cache) {
  if (choice.empty()) {
    const DefaultReference chosen = DefaultChoice(scene);
    RTB_ASSIGN_OR_RETURN(ReferencePicture picture,
                         ChooseReference(chosen.name, scene, raster, cache));
    picture.notes = chosen.notes;
    return picture;
  }
  if (choice == "self") return RenderSelf(scene, raster, cache);
  ReferencePicture picture;
  picture.name = choice;
  picture.file = choice;
  if (IsRenderer(choice)) {
    RTB_ASSIGN_OR_RETURN(picture.file, CommittedFile(choice, scene));
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
