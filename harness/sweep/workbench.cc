#include "harness/sweep/workbench.h"

#include "harness/arguments.h"
#include "harness/cell_shape.h"
#include "harness/measure/cache.h"
#include "harness/sweep/suite.h"

namespace rtb {

BenchRequest RequestOf(const SweepUnit& unit, int threads) {
  const UnitConfiguration& c = unit.configuration;
  BenchRequest request;
  request.scene.scene = unit.scene_file.string();
  request.scene.backend = c.backend;
  request.scene.options.time = c.time;
  request.scene.options.spp = c.spp;
  request.scene.options.seed = c.seed;
  request.scene.options.integrator = c.integrator;
  request.scene.options.threads = threads;
  request.grid = c.grid;
  request.depth = unit.depth;
  request.reference = unit.reference;
  request.repeat = 0;
  request.cache = CacheFolder();
  return request;
}

Result<const PreparedScene*> Workbench::Scene(const SweepUnit& unit) {
  const SceneRequest request = RequestOf(unit, threads_).scene;
  const std::string key = request.scene + "\n" + request.backend;
  if (key != scene_key_) {
    reference_key_.clear();
    converged_key_.clear();
    scene_ = PrepareScene(request);
    scene_key_ = key;
  }
  if (!scene_) return Fail(scene_.error());
  scene_->options = request.options;
  return &*scene_;
}

Result<BenchStage> Workbench::Stage(const SweepUnit& unit) {
  const UnitConfiguration& c = unit.configuration;
  RTB_ASSIGN_OR_RETURN(const PreparedScene* const scene, Scene(unit));
  RTB_ASSIGN_OR_RETURN(const PixelSize raster,
                       RasterSize(c.grid, CellOf(DecodeOptions{})));
  const std::filesystem::path cache = CacheFolder();
  const std::string picture =
      c.integrator + "\n" + NumberText(c.time) + "\n" + GridText(c.grid);
  if (reference_key_ != unit.reference + "\n" + picture) {
    reference_ = ChooseReference(unit.reference, *scene, raster, cache);
    reference_key_ = unit.reference + "\n" + picture;
  }
  if (!reference_) return Fail(reference_.error());
  if (converged_key_ != picture) {
    converged_ = ConvergedPicture(*scene, raster, cache);
    converged_key_ = picture;
  }
  if (!converged_) return Fail(converged_.error());
  return BenchStage{*scene, *reference_, *converged_};
}

}  // namespace rtb
