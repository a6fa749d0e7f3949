#include "harness/live/progressive_image.h"

#include "core/image/io.h"

namespace rtb {

Status ProgressiveImage::Aim(const LiveView& view) {
  if (aimed_ && SameSamples(view, view_)) return {};
  const bool scene_stays =
      aimed_ && view.scene == view_.scene && view.backend == view_.backend;
  aimed_ = false;
  if (!scene_stays) {
    scene_ = {};
    RTB_ASSIGN_OR_RETURN(scene_, PrepareScene({.scene = view.scene,
                                               .backend = view.backend,
                                               .exposure = {},
                                               .options = {}}));
  }
  view_ = view;
  rays_ = 0;
  sums_.assign(
      static_cast<std::size_t>(view.grid.cells()) * kCellWidth * kCellHeight,
      Rgb(0));
  aimed_ = true;
  return {};
}

Status ProgressiveImage::Step(int rays) {
  RenderOptions options;
  options.time = view_.time;
  options.spp = rays;
  options.seed = view_.seed + static_cast<std::uint64_t>(rays_) + 1;
  options.max_depth = view_.max_depth;
  options.threads = 1;
  options.integrator = view_.integrator;
  options.camera = view_.camera;
  RTB_ASSIGN_OR_RETURN(
      const Fragments fragments,
      scene_.backend->Render(
          RegularPlan(view_.grid, kCellWidth, kCellHeight, view_.cell_aspect),
          options));
  for (std::size_t i = 0; i < sums_.size(); ++i) {
    sums_[i] += fragments.values[i] * static_cast<float>(rays);
  }
  rays_ += rays;
  return {};
}

Image ProgressiveImage::Displayed() const {
  Image linear(view_.grid.columns * kCellWidth, view_.grid.rows * kCellHeight);
  const float scale = 1 / static_cast<float>(rays_);
  std::size_t at = 0;
  for (int cell = 0; cell < view_.grid.cells(); ++cell) {
    const int left = cell % view_.grid.columns * kCellWidth;
    const int top = cell / view_.grid.columns * kCellHeight;
    for (int y = 0; y < kCellHeight; ++y) {
      for (int x = 0; x < kCellWidth; ++x) {
        linear.at(left + x, top + y) = sums_[at++] * scale;
      }
    }
  }
  return DisplayEncoded(linear, view_.exposure.value_or(scene_.exposure), true);
}

}  // namespace rtb
