#include "encoders/fit/color_fit.h"

#include <algorithm>

#include "encoders/fit/channel_fit.h"
#include "encoders/fit/oklab_fit.h"

namespace rtb {
namespace {

constexpr int kChannels = 3;

/// Components in the order of the channels.
Rgb8 FromCodes(const int (&codes)[kChannels]) {
  return {static_cast<std::uint8_t>(codes[0]),
          static_cast<std::uint8_t>(codes[1]),
          static_cast<std::uint8_t>(codes[2])};
}

}  // namespace

double ErrorOfPair(const FitMask& mask, const CenteredSamples& samples,
                   const V3d& correlation, const ColorPair& colors) {
  double error = samples.squares;
  for (int c = 0; c < kChannels; ++c) {
    error +=
        PairCost(mask, correlation[c])
            .At(colors.fg[c] - samples.mean[c], colors.bg[c] - samples.mean[c]);
  }
  return std::max(0.0, error);
}

ColorPair SolveDisplayable(const FitMask& mask, Blend blend,
                           const CenteredSamples& samples,
                           const V3d& correlation) {
  if (blend == Blend::kOklab) return SolveOklab(mask, samples, correlation);
  ColorPair colors;
  for (int c = 0; c < kChannels; ++c) {
    const double mean = samples.mean[c];
    const ValuePair pair =
        SolvePairWithin(mask, correlation[c], 0 - mean, 1 - mean);
    colors.fg[c] = pair.fg + mean;
    colors.bg[c] = pair.bg + mean;
  }
  return colors;
}

CodesFit SolveCodes(const FitMask& mask, Blend blend,
                    const CenteredSamples& samples, const V3d& correlation) {
  if (blend == Blend::kOklab) {
    return SolveOklabCodes(mask, samples, correlation);
  }
  int fg[kChannels];
  int bg[kChannels];
  double error = samples.squares;
  for (int c = 0; c < kChannels; ++c) {
    const CodePair codes =
        BestCodes(mask, correlation[c], CodeValues(blend), samples.mean[c]);
    fg[c] = codes.fg;
    bg[c] = codes.bg;
    error += codes.cost;
  }
  return {FromCodes(fg), FromCodes(bg), std::max(0.0, error)};
}

}  // namespace rtb
