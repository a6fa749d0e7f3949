#include "harness/image_source.h"

#include <cmath>

#include "core/base/parallel.h"
#include "core/image/resample.h"
#include "harness/arguments.h"

namespace rtb {
namespace {

/// Samples along one side of a cell, for footprints laid side by side.
long Tiles(float footprint) { return std::lround(1.0 / footprint); }

bool HasPlansSize(const SamplePlan& plan, int width, int height) {
  return width == plan.grid.columns * Tiles(plan.footprint.x) &&
         height == plan.grid.rows * Tiles(plan.footprint.y);
}

/// The mean over one sample's footprint.
Rgb Sample(const Image& image, const ImageMapping& map, const SamplePlan& plan,
           int entry, int sample) {
  const V2f& at = plan.position(entry, sample);
  const int cell = plan.cell(entry);
  const double u = cell % plan.grid.columns + static_cast<double>(at.x);
  const double v =
      static_cast<double>(cell / plan.grid.columns) + static_cast<double>(at.y);
  const double half_x = 0.5 * static_cast<double>(plan.footprint.x);
  const double half_y = 0.5 * static_cast<double>(plan.footprint.y);
  return BoxMean(image, map.left + (u - half_x) * map.pitch_x,
                 map.top + (v - half_y) * map.pitch_y,
                 map.left + (u + half_x) * map.pitch_x,
                 map.top + (v + half_y) * map.pitch_y);
}

}  // namespace

Result<Fit> ParseFit(const std::string& place, const std::string& text) {
  if (text == "contain") return Fit::kContain;
  if (text == "stretch") return Fit::kStretch;
  if (text == "cover") return Fit::kCover;
  return Fail(BadInput(
      place, "found '" + text + "', expected contain, stretch or cover"));
}

ImageMapping MapImage(const SamplePlan& plan, int width, int height, Fit fit) {
  ImageMapping map;
  map.pitch_x = static_cast<double>(width) / plan.grid.columns;
  map.pitch_y = static_cast<double>(height) / plan.grid.rows;
  if (fit == Fit::kStretch || HasPlansSize(plan, width, height)) return map;
  // One of the picture's sides, in square image pixels, stays the image's; the
  // other follows from the picture's aspect, and the image is centered in it.
  const bool image_is_wider = width > height * plan.aspect();
  if (image_is_wider == (fit == Fit::kContain)) {
    const double picture_height = width / plan.aspect();
    map.pitch_y = picture_height / plan.grid.rows;
    map.top = 0.5 * (height - picture_height);
  } else {
    const double picture_width = height * plan.aspect();
    map.pitch_x = picture_width / plan.grid.columns;
    map.left = 0.5 * (width - picture_width);
  }
  return map;
}

ImageSource::ImageSource(const Image& linear, Fit fit, int threads)
    : linear_(linear), fit_(fit), threads_(threads) {}

Result<Fragments> ImageSource::Query(const SamplePlan& plan) {
  RTB_RETURN_IF_ERROR(CheckSampleCount("--grid", plan));
  const ImageMapping map =
      MapImage(plan, linear_.width(), linear_.height(), fit_);
  Fragments fragments(plan);
  ParallelFor(plan.entries(), 64, threads_, [&](int begin, int end) {
    for (int entry = begin; entry < end; ++entry) {
      const auto samples = fragments.cell(entry);
      for (int i = 0; i < plan.samples_per_cell; ++i) {
        samples[static_cast<std::size_t>(i)] =
            Sample(linear_, map, plan, entry, i);
      }
    }
  });
  return fragments;
}

}  // namespace rtb
