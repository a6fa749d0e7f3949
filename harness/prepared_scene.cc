#include "harness/prepared_scene.h"

#include <algorithm>
#include <cstdint>
#include <numeric>

#include "core/scene/load.h"
#include "harness/lookup.h"

namespace rtb {
namespace {

/// Rows that are rendered together: so many rays that nothing is lost by
/// waiting for the last of them, and progress shows every few seconds.
int RowsOfBand(PixelSize size, int spp) {
  constexpr std::int64_t kRays = 1 << 22;
  const std::int64_t rays_of_row = std::int64_t{size.width} * spp;
  return static_cast<int>(
      std::clamp<std::int64_t>(kRays / rays_of_row, 1, size.height));
}

}  // namespace

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
                          const RenderOptions& options,
                          const std::function<void(double)>& progress) {
  Image image(size.width, size.height);
  const int rows = RowsOfBand(size, options.spp);
  SamplePlan plan = PixelPlan(size.width, size.height);
  for (int y = 0; y < size.height; y += rows) {
    const int begin = y * size.width;
    if (rows < size.height) {
      const int end = std::min(y + rows, size.height) * size.width;
      plan.cells.resize(static_cast<std::size_t>(end - begin));
      std::iota(plan.cells.begin(), plan.cells.end(), begin);
    }
    RTB_ASSIGN_OR_RETURN(const Fragments fragments,
                         backend.Render(plan, options));
    std::ranges::copy(fragments.values, image.pixels().begin() + begin);
    progress(std::min(1.0, static_cast<double>(y + rows) / size.height));
  }
  return image;
}

}  // namespace rtb
