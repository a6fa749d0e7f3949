#include "encoders/adaptive/samples.h"

#include "core/color/srgb.h"

namespace rtb {
namespace {

/// NaN becomes 0, as does what is below it.
void Clip(std::span<const Rgb> colors, std::span<Rgb> clipped) {
  for (std::size_t i = 0; i < colors.size(); ++i) {
    for (int channel = 0; channel < 3; ++channel) {
      const float value = colors[i][channel];
      const float above = value > 0 ? value : 0;
      clipped[i][channel] = above < kBrightest ? above : kBrightest;
    }
  }
}

}  // namespace

void SeenSamples::Add(const SamplePlan& plan, const Fragments& fragments) {
  std::vector<Rgb> encoded(fragments.values.size());
  SrgbEncode(fragments.values, encoded);
  std::vector<Rgb> linear(encoded.size());
  Clip(fragments.values, linear);
  std::size_t value = 0;
  samples_.resize(samples_.size() + encoded.size());
  SeenSample* next = samples_.data() + (samples_.size() - encoded.size());
  for (int entry = 0; entry < plan.entries(); ++entry) {
    const int cell = plan.cell(entry);
    counts_[static_cast<std::size_t>(cell)] += plan.samples_per_cell;
    for (int i = 0; i < plan.samples_per_cell; ++i, ++value, ++next) {
      next->cell = cell;
      next->position = plan.position(entry, i);
      next->linear = linear[value];
      next->encoded = encoded[value];
    }
  }
  AddVariances(plan, fragments.variances);
}

void SeenSamples::AddVariances(const SamplePlan& plan,
                               std::span<const float> variances) {
  const auto each = static_cast<std::size_t>(plan.samples_per_cell);
  for (std::size_t i = 0; i < variances.size(); ++i) {
    const int cell = plan.cell(static_cast<int>(i / each));
    variances_[static_cast<std::size_t>(cell)] += variances[i];
  }
}

}  // namespace rtb
