// Encoder `adaptive`: a few rays everywhere, then more where they change the
// picture; the glyphs and colors of least squared error on the raster that is
// rebuilt from them. This project's own; docs/adaptive.md explains it.
#include <algorithm>
#include <iterator>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "core/base/parallel.h"
#include "encoders/adaptive/rebuild.h"
#include "encoders/adaptive/tracer.h"
#include "encoders/encode_cells.h"
#include "encoders/fit/atlas_parameters.h"
#include "encoders/fit/batch_fit.h"
#include "encoders/fit/fit.h"
#include "encoders/modifiers/median.h"
#include "encoders/modifiers/modifiers.h"
#include "encoders/parameters.h"
#include "encoders/registry.h"

namespace rtb {
namespace {

constexpr int kGrain = 16;

/// Each place of the raster is the mean of three samples, drawn towards that of
/// many where there is noise: a little over a third of their variance.
constexpr double kRebuiltNoise = 0.58;

const EncoderParameter& RaysParameter() {
  static const EncoderParameter parameter{
      "rays", "8", "number in 1..64",
      "rays at most, mean over all cells of the grid"};
  return parameter;
}

const EncoderParameter& ColorParameter() {
  static const EncoderParameter parameter{
      "color", "mean", "mean|median",
      "the two colors: of least squared error, or the geometric median of each "
      "side, with more rays for faint contrasts"};
  return parameter;
}

struct Settings {
  double rays = 8;
  ColorRule color = ColorRule::kMean;
  Blend blend = Blend::kSrgb;
  std::optional<std::uint64_t> seed;
};

class Adaptive : public Encoder {
 public:
  Adaptive(Atlas atlas, const Settings& settings)
      : atlas_(std::move(atlas)), settings_(settings), batch_(atlas_) {}

  std::vector<char32_t> Candidates() const override { return atlas_.glyphs(); }

  Result<Encoding> Run(FragmentSource& source, GridSize grid,
                       double cell_aspect,
                       const EncodeContext& context) const override {
    RTB_ASSIGN_OR_RETURN(
        const SeenSamples samples,
        TraceAdaptively(
            source, {grid, cell_aspect, settings_.rays,
                     settings_.color == ColorRule::kMean ? Priority::kSquare
                                                         : Priority::kRoot,
                     settings_.seed.value_or(context.seed), context.threads}));
    const RebuiltRaster raster =
        Rebuild(samples, atlas_.width(), atlas_.height(), cell_aspect,
                settings_.color == ColorRule::kMean ? Texture::kExpected
                                                    : Texture::kKept,
                context.threads);
    Encoding encoding;
    encoding.rays_per_cell =
        static_cast<double>(samples.all().size()) / grid.cells();
    encoding.evidence =
        EvidenceOf(raster, samples, cell_aspect, encoding.rays_per_cell);
    encoding.grid = Choose(encoding.evidence.rounds[0].fragments, context);
    return encoding;
  }

 private:
  /// What `optimal` chooses for the raster, in median colors where these are
  /// asked for.
  CellGrid Choose(const Fragments& raster, const EncodeContext& context) const {
    CellGrid grid = ChooseOptimal(raster, context);
    if (settings_.color == ColorRule::kMean) return grid;
    ParallelFor(
        raster.grid.cells(), kGrain, context.threads, [&](int begin, int end) {
          for (int i = begin; i < end; ++i) {
            Cell& cell = grid.cells[static_cast<std::size_t>(i)];
            cell = WithMedianColors(cell, MaskOf(cell.glyph), settings_.blend,
                                    InBlendSpace(raster.cell(i)));
          }
        });
    return grid;
  }

  CellGrid ChooseOptimal(const Fragments& raster,
                         const EncodeContext& context) const {
    const int samples = atlas_.width() * atlas_.height();
    if (settings_.blend == Blend::kSrgb && !context.scalar) {
      return EncodeCells(
          raster, samples, context.threads,
          [this](std::span<const Rgb> linear, std::span<Cell> cells) {
            batch_.Fit(linear, cells);
          });
    }
    return EncodeCells(
        raster, samples, context.threads, [this](std::span<const Rgb> linear) {
          return FitCell(atlas_, settings_.blend, InBlendSpace(linear)).cell;
        });
  }

  const FitMask& MaskOf(char32_t glyph) const {
    return atlas_.candidates()[static_cast<std::size_t>(atlas_.Find(glyph))];
  }

  std::vector<V3d> InBlendSpace(std::span<const Rgb> linear) const {
    std::vector<V3d> samples(linear.size());
    ToBlend(settings_.blend, linear, samples);
    return samples;
  }

  /// The raster in 8 bits, as if every sub-pixel had been sampled, with as much
  /// noise as the samples of its cell.
  Evidence EvidenceOf(const RebuiltRaster& raster, const SeenSamples& samples,
                      double cell_aspect, double rays_per_cell) const {
    SampleRound round;
    round.plan =
        RegularPlan(samples.grid(), raster.width, raster.height, cell_aspect);
    round.fragments = Fragments(round.plan);
    std::ranges::transform(
        raster.encoded, round.fragments.values.begin(),
        [](const Rgb& color) { return Decode8(QuantizeEncoded(color)); });
    for (int cell = 0; cell < samples.grid().cells(); ++cell) {
      round.fragments.variances.insert(round.fragments.variances.end(),
                                       raster.cell(cell).size(),
                                       samples.variance(cell));
    }
    Evidence evidence;
    evidence.weight =
        std::min(1.0, rays_per_cell / round.plan.samples_per_cell);
    evidence.noise = kRebuiltNoise;
    evidence.rounds.push_back(std::move(round));
    return evidence;
  }

  Atlas atlas_;
  Settings settings_;
  BatchFit batch_;
};

Result<std::unique_ptr<Encoder>> Make(const EncoderParameters& given) {
  Settings settings;
  RTB_ASSIGN_OR_RETURN(settings.rays,
                       ReadNumber(RaysParameter(), given, 1, 64));
  RTB_ASSIGN_OR_RETURN(const int color, ReadChoice(ColorParameter(), given));
  settings.color = static_cast<ColorRule>(color);
  RTB_ASSIGN_OR_RETURN(settings.blend, ReadBlend(given));
  RTB_ASSIGN_OR_RETURN(settings.seed, ReadSeed(given));
  RTB_ASSIGN_OR_RETURN(Atlas atlas, ReadAtlas(given));
  return std::make_unique<Adaptive>(std::move(atlas), settings);
}

}  // namespace

EncoderEntry adaptive_entry() {
  std::vector<EncoderParameter> parameters = {RaysParameter()};
  std::ranges::copy(AtlasParameters(), std::back_inserter(parameters));
  parameters.push_back(ColorParameter());
  parameters.push_back(BlendParameter());
  parameters.push_back(SeedParameter());
  return {{"adaptive",
           "rays where they pay, then the glyph and colors of least squared "
           "error on what they show",
           8, "space, U+2588 and what `glyphs` names", std::move(parameters)},
          Make};
}

}  // namespace rtb
