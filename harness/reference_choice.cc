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

/// Renderers whose images show what the integrator computes: POV-Ray's show
/// direct light and mirrors alone, as `whitted` does.
std::vector<const char*> RenderersFor(const std::string& integrator) {
  if (integrator == "path") return {"cycles"};
  return {"povray", "cycles"};
}

/// What is taken where nothing is asked for.
ReferenceSource DefaultSource(const PreparedScene& scene) {
  ReferenceSource choice{"self"};
  for (const char* renderer : RenderersFor(scene.options.integrator)) {
    const auto file = FindReference(scene.file, renderer, scene.options.time);
    if (!file) continue;
    const Status fits =
        CheckProvenance(*file, renderer, *scene.scene, scene.options.time);
    if (fits) {
      choice.name = renderer;
      choice.file = *file;
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

Result<Image> RenderSelf(const PreparedScene& scene, PixelSize raster,
                         const std::filesystem::path& cache) {
  RTB_ASSIGN_OR_RETURN(
      const Image linear,
      ConvergedImage(scene, scene.options.time, raster, cache));
  return DisplayEncoded(linear, scene.exposure, true);
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

Result<ReferenceSource> FindReferenceSource(const std::string& choice,
                                            const PreparedScene& scene) {
  if (choice.empty()) return DefaultSource(scene);
  ReferenceSource source{choice};
  if (IsRenderer(choice)) {
    RTB_ASSIGN_OR_RETURN(source.file, CommittedFile(choice, scene));
  } else if (choice != "self") {
    source.file = choice;
    source.name = source.file.filename().string();
  }
  return source;
}

Result<ReferencePicture> ChooseReference(const std::string& choice,
                                         const PreparedScene& scene,
                                         PixelSize raster,
                                         const std::filesystem::path& cache) {
  RTB_ASSIGN_OR_RETURN(ReferenceSource source,
                       FindReferenceSource(choice, scene));
  ReferencePicture picture;
  if (source.file.empty()) {
    RTB_ASSIGN_OR_RETURN(picture.display, RenderSelf(scene, raster, cache));
  } else {
    RTB_ASSIGN_OR_RETURN(picture.display,
                         ReadDisplayed(source.file, scene.exposure));
  }
  picture.name = std::move(source.name);
  picture.file = std::move(source.file);
  picture.notes = std::move(source.notes);
  Status same =
      CheckAspects({picture.display.width(), picture.display.height()}, raster,
                   "--reference");
  if (same) return picture;
  same.error().hint = "--reference=self renders the reference for any grid";
  return Fail(std::move(same.error()));
}

}  // namespace rtb
