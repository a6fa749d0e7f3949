#include "harness/prepared_scene.h"

#include <algorithm>

#include "core/scene/load.h"
#include "harness/lookup.h"

namespace rtb {

Result<PreparedScene> LoadNamedScene(const std::string& name_or_file) {
  PreparedScene prepared;
  RTB_ASSIGN_OR_RETURN(prepared.file,
                       FindScene(FindDataFolders(), name_or_file));
  RTB_ASSIGN_OR_RETURN(Scene scene, LoadScene(prepared.file));
  prepared.scene = std::make_unique<Scene>(std::move(scene));
  prepared.exposure = prepared.scene->settings.exposure;
  return prepared;
}

Result<PreparedScene> PrepareScene(const SceneRequest& request) {
  RTB_ASSIGN_OR_RETURN(PreparedScene prepared, LoadNamedScene(request.scene));
  RTB_ASSIGN_OR_RETURN(prepared.backend,
                       MakeBackend(request.backend, *prepared.scene));
  prepared.options = request.options;
  if (request.exposure) prepared.exposure = *request.exposure;
  return prepared;
}

Result<Image> RenderImage(Backend& backend, PixelSize size,
                          const RenderOptions& options) {
  RTB_ASSIGN_OR_RETURN(
      const Fragments fragments,
      backend.Render(PixelPlan(size.width, size.height), options));
  Image image(size.width, size.height);
  std::copy(fragments.values.begin(), fragments.values.end(),
            image.pixels().begin());
  return image;
}

}  // namespace rtb
