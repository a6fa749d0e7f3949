/// @file
/// Modifiers: parameters that any encoder takes. An encoder that lists one of
/// them among its own parameters takes it itself.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <span>

#include "encoders/blend.h"
#include "encoders/encoder.h"
#include "encoders/parameters.h"

namespace rtb {

/// How the two colors come from the samples of each side.
enum class ColorRule {
  kMean,    ///< As the encoder chooses them.
  kMedian,  ///< The geometric median of each side.
};

/// How samples are moved before they meet a palette.
enum class Dither {
  kNone,
  kBayer,           ///< An ordered 8 x 8 matrix over parts of cells.
  kRandom,          ///< Random offsets.
  kFloydSteinberg,  ///< What a cell leaves is handed on to its neighbors.
};

/// The values of all modifiers.
struct Modifiers {
  ColorRule color = ColorRule::kMean;
  double temporal = 0;          ///< Z of the test; 0 = off.
  std::optional<double> sigma;  ///< Of a sample's noise, values in 0..1.
  Dither dither = Dither::kNone;
  /// The font whose masks decide; none: geometric ones.
  std::optional<std::filesystem::path> atlas;
  Blend blend = Blend::kSrgb;  ///< The encoder's, where it has one.
};

/// What users may give: color, temporal, sigma, dither, atlas.
std::span<const EncoderParameter> ModifierParameters();

/// Reads those of the modifiers that are given.
Result<Modifiers> ReadModifiers(const EncoderParameters& given);

/// An encoder that applies modifiers, and the context's color depth, to what
/// another one chooses.
std::unique_ptr<Encoder> MakeModified(std::unique_ptr<Encoder> encoder,
                                      const Modifiers& modifiers);

}  // namespace rtb
