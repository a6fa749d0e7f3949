#include "encoders/modifiers/raster.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/parallel.h"

namespace rtb {
namespace {

constexpr int kGrain = 64;
/// The raster of scattered samples.
constexpr int kFallbackWidth = 8;
constexpr int kFallbackHeight = 16;

/// Sub-pixels of a cell.
struct CellRaster {
  int width;
  int height;
};

/// The size of the evidence, where it is one regular raster.
std::optional<CellRaster> RegularSize(const Evidence& evidence) {
  if (evidence.rounds.size() != 1) return std::nullopt;
  const SamplePlan& plan = evidence.rounds[0].plan;
  if (!plan.uniform() || !plan.cells.empty()) return std::nullopt;
  const CellRaster size{static_cast<int>(std::lround(1 / plan.footprint.x)),
                        static_cast<int>(std::lround(1 / plan.footprint.y))};
  const bool regular =
      size.width * size.height == plan.samples_per_cell &&
      RegularPlan(plan.grid, size.width, size.height).positions ==
          plan.positions;
  return regular ? std::optional(size) : std::nullopt;
}

SampleRaster BlackRaster(const Evidence& evidence, int width, int height) {
  SampleRaster raster;
  raster.grid = evidence.rounds.at(0).plan.grid;
  raster.width = width;
  raster.height = height;
  raster.values.resize(
      static_cast<std::size_t>(raster.grid.cells() * width * height), V3d(0));
  return raster;
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

SampleRaster NearestRaster(const Evidence& evidence, int width, int height,
                           Blend blend, int threads) {
  SampleRaster raster = BlackRaster(evidence, width, height);
  const SamplesByCell samples(evidence);
  ParallelFor(raster.grid.cells(), kGrain, threads, [&](int begin, int end) {
    for (int cell = begin; cell < end; ++cell) {
      FillCell(samples.cell(cell), blend, raster, raster.cell(cell));
    }
  });
  return raster;
}

SampleRaster RasterOf(const Evidence& evidence, Blend blend, int threads) {
  const std::optional<CellRaster> regular = RegularSize(evidence);
  if (!regular) {
    return NearestRaster(evidence, kFallbackWidth, kFallbackHeight, blend,
                         threads);
  }
  SampleRaster raster = BlackRaster(evidence, regular->width, regular->height);
  ToBlend(blend, evidence.rounds[0].fragments.values, raster.values);
  return raster;
}

}  // namespace rtb
