#include "encoders/adaptive/samples.h"

#include <algorithm>

#include "core/color/srgb.h"

namespace rtb {
namespace {

/// In this order of arguments NaN becomes 0.
float Clip(float value) { return std::min(std::max(0.0f, value), 1.0f); }

Rgb Clip(const Rgb& color) {
  return {Clip(color.x), Clip(color.y), Clip(color.z)};
}

}  // namespace

void SeenSamples::Add(const SamplePlan& plan, const Fragments& fragments) {
  std::vector<Rgb> encoded(fragments.values.size());
  SrgbEncode(fragments.values, encoded);
  std::size_t value = 0;
  for (int entry = 0; entry < plan.entries(); ++entry) {
    const int cell = plan.cell(entry);
    const auto place = static_cast<std::size_t>(cell);
    counts_[place] += plan.samples_per_cell;
    for (int i = 0; i < plan.samples_per_cell; ++i, ++value) {
      if (!fragments.variances.empty()) {
        variances_[place] += fragments.variances[value];
      }
      samples_.push_back({cell, plan.position(entry, i),
                          Clip(fragments.values[value]), encoded[value]});
    }
  }
}

}  // namespace rtb
