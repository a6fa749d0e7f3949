#include "encoders/fit/fit.h"

#include "core/base/check.h"
#include "encoders/fit/choose.h"
#include "encoders/fit/color_fit.h"

namespace rtb {
namespace {

UnroundedFit SolveUnrounded(const FitMask& mask, Blend blend,
                            const CenteredSamples& centered,
                            const V3d& correlation) {
  const ColorPair colors = SolveDisplayable(mask, blend, centered, correlation);
  return {colors.fg, colors.bg,
          ErrorOfPair(mask, centered, correlation, colors), 0};
}

}  // namespace

CellFit FitCell(const Atlas& atlas, Blend blend, std::span<const V3d> samples) {
  const CenteredSamples centered = Center(samples);
  const std::vector<Prospect> prospects = Survey(atlas, centered);
  return ChooseBest(prospects, [&](std::size_t i) {
    const FitMask& mask = atlas.candidates()[i];
    const CodesFit codes =
        SolveCodes(mask, blend, centered, prospects[i].correlation);
    return CellFit{
        {mask.glyph, codes.fg, codes.bg}, codes.error, static_cast<int>(i)};
  });
}

CellFit RefitColors(const FitMask& mask, Blend blend,
                    std::span<const V3d> samples) {
  const CenteredSamples centered = Center(samples);
  const CodesFit codes =
      SolveCodes(mask, blend, centered, Correlate(mask, centered));
  return {{mask.glyph, codes.fg, codes.bg}, codes.error, 0};
}

double ErrorOf(const FitMask& mask, const Cell& cell, Blend blend,
               std::span<const V3d> samples) {
  RTB_CHECK_EQ(mask.coverage.size(), samples.size());
  const V3d fg = FromRgb8(blend, cell.fg);
  const V3d bg = FromRgb8(blend, cell.bg);
  double error = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double m = mask.coverage[i];
    error += (fg * m + bg * (1 - m) - samples[i]).length2();
  }
  return error;
}

UnroundedFit FitCellUnrounded(const Atlas& atlas, Blend blend,
                              std::span<const V3d> samples) {
  const CenteredSamples centered = Center(samples);
  const std::vector<Prospect> prospects = Survey(atlas, centered);
  return ChooseBest(prospects, [&](std::size_t i) {
    UnroundedFit fit = SolveUnrounded(atlas.candidates()[i], blend, centered,
                                      prospects[i].correlation);
    fit.candidate = static_cast<int>(i);
    return fit;
  });
}

UnroundedFit RefitUnrounded(const FitMask& mask, Blend blend,
                            std::span<const V3d> samples) {
  const CenteredSamples centered = Center(samples);
  return SolveUnrounded(mask, blend, centered, Correlate(mask, centered));
}

}  // namespace rtb
