// Encoder `quadrant`: 2 x 2 samples, each in one of two colors. Origin:
// RAYTERM's "Quadrant Algorithm".
#include <algorithm>
#include <array>
#include <memory>

#include "core/color/hsp.h"
#include "encoders/blend.h"
#include "encoders/encode_cells.h"
#include "encoders/glyphs/patterns.h"
#include "encoders/partition.h"
#include "encoders/plan_encoder.h"
#include "encoders/registry.h"

namespace rtb {
namespace {

constexpr int kSamples = 4;
using Samples = std::array<V3d, kSamples>;

/// In the order of the parameter's values.
enum class Split { kBrightness, kRange, kBest };

const EncoderParameter& SplitParameter() {
  static const EncoderParameter parameter{
      "split", "brightness", "brightness|range|best",
      "what decides which quadrants are on: brightness above the mean, the "
      "channel of the largest range above its middle, or the least squared "
      "error"};
  return parameter;
}

/// Samples whose value is greater than the threshold.
SampleMask Above(const std::array<double, kSamples>& values, double threshold) {
  SampleMask mask = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (values[i] > threshold + kNoise) mask |= SampleMask{1} << i;
  }
  return mask;
}

/// HSP brightness above the mean of the four.
SampleMask SplitByBrightness(const Samples& encoded) {
  std::array<double, kSamples> values;
  std::ranges::transform(encoded, values.begin(), HspBrightness);
  return Above(values, (values[0] + values[1] + values[2] + values[3]) / 4);
}

/// The channel of the largest range (the first of equal ones) above its
/// middle.
SampleMask SplitByRange(const Samples& encoded) {
  std::array<double, kSamples> widest{};
  double widest_range = -1;
  double middle = 0;
  for (int channel = 0; channel < 3; ++channel) {
    std::array<double, kSamples> values;
    std::ranges::transform(encoded, values.begin(),
                           [&](const V3d& color) { return color[channel]; });
    const auto [low, high] = std::ranges::minmax(values);
    if (high - low <= widest_range + kNoise) continue;
    widest = values;
    widest_range = high - low;
    middle = (low + high) / 2;
  }
  return Above(widest, middle);
}

class Quadrant : public PlanEncoder {
 public:
  Quadrant(Split split, Blend blend) : split_(split), blend_(blend) {}

  std::vector<char32_t> Candidates() const override {
    return GlyphsOfPatterns(QuadrantGlyph, kSamples);
  }

  SamplePlan Plan(GridSize grid, double cell_aspect,
                  std::uint64_t /*seed*/) const override {
    return RegularPlan(grid, 2, 2, cell_aspect);
  }

  Result<CellGrid> Encode(const Fragments& fragments,
                          const EncodeContext& context) const override {
    return EncodeCells(
        fragments, kSamples, context.threads,
        [this](std::span<const Rgb> linear) { return EncodeCell(linear); });
  }

 private:
  Cell EncodeCell(std::span<const Rgb> linear) const {
    Samples samples;
    ToBlend(blend_, linear, samples);
    const SampleMask on = ChooseOn(linear, samples);
    return CellOfMeans(blend_, samples, on, QuadrantGlyph(on));
  }

  SampleMask ChooseOn(std::span<const Rgb> linear,
                      const Samples& samples) const {
    if (split_ == Split::kBest) {
      return BrighterSide(blend_, samples, BestPartition(samples));
    }
    Samples encoded;
    ToBlend(Blend::kSrgb, linear, encoded);
    if (split_ == Split::kBrightness) return SplitByBrightness(encoded);
    return BrighterSide(blend_, samples, SplitByRange(encoded));
  }

  Split split_;
  Blend blend_;
};

Result<std::unique_ptr<Encoder>> Make(const EncoderParameters& given) {
  RTB_ASSIGN_OR_RETURN(const int split, ReadChoice(SplitParameter(), given));
  RTB_ASSIGN_OR_RETURN(const Blend blend, ReadBlend(given));
  return std::make_unique<Quadrant>(static_cast<Split>(split), blend);
}

}  // namespace

EncoderEntry quadrant_entry() {
  return {{"quadrant",
           "quadrants above and below a threshold, in two colors",
           kSamples,
           "space, U+2580, U+2584, U+258C, U+2590, U+2596-259F",
           {SplitParameter(), BlendParameter()}},
          Make};
}

}  // namespace rtb
