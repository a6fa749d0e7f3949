#include "encoders/modifiers/raster.h"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"

namespace rtb {
namespace {

constexpr int kGrain = 64;
/// The raster of scattered samples.
constexpr int kFallbackWidth = 8;
constexpr int kFallbackHeight = 16;

/// Whether the evidence is one regular raster; its size goes to `raster`.
bool IsRegular(const Evidence& evidence, SampleRaster& raster) {
  if (evidence.rounds.size() != 1) return false;
  const SamplePlan& plan = evidence.rounds[0].plan;
  if (!plan.uniform() || !plan.cells.empty()) return false;
  raster.width = static_cast<int>(std::lround(1 / plan.footprint.x));
  raster.height = static_cast<int>(std::lround(1 / plan.footprint.y));
  return raster.width * raster.height == plan.samples_per_cell &&
         RegularPlan(plan.grid, raster.width, raster.height).positions ==
             plan.positions;
}

/// The sample nearest to a point of the cell, the cell being twice as high as
/// wide; the first of equal ones.
const CellSample& Nearest(std::span<const CellSample> samples, V2f point) {
  return *std::ranges::min_element(samples, {}, [&](const CellSample& sample) {
    const V2f way = (sample.position - point) * V2f(1, 2);
    return way.length2();
  });
}

void FillCell(std::span<const CellSample> samples, Blend blend,
              const SampleRaster& raster, std::span<V3d> out) {
  for (int y = 0; y < raster.height; ++y) {
    for (int x = 0; x < raster.width; ++x) {
      const V2f center(
          (static_cast<float>(x) + 0.5f) / static_cast<float>(raster.width),
          (static_cast<float>(y) + 0.5f) / static_cast<float>(raster.height));
      const auto at = static_cast<std::size_t>(y * raster.width + x);
      ToBlend(blend, std::span(&Nearest(samples, center).linear, 1),
              out.subspan(at, 1));
    }
  }
}

}  // namespace

SampleRaster RasterOf(const Evidence& evidence, Blend blend, int threads) {
  SampleRaster raster;
  raster.grid = evidence.rounds.at(0).plan.grid;
  const bool regular = IsRegular(evidence, raster);
  if (!regular) {
    raster.width = kFallbackWidth;
    raster.height = kFallbackHeight;
  }
  raster.values.resize(static_cast<std::size_t>(raster.grid.cells() *
                                                raster.width * raster.height),
                       V3d(0));
  if (regular) {
    ToBlend(blend, evidence.rounds[0].fragments.values, raster.values);
    return raster;
  }
  const SamplesByCell samples(evidence);
  ParallelFor(raster.grid.cells(), kGrain, threads, [&](int begin, int end) {
    for (int cell = begin; cell < end; ++cell) {
      FillCell(samples.cell(cell), blend, raster, raster.cell(cell));
    }
  });
  return raster;
}

}  // namespace rtb
