/// @file
/// SampledMasks: how much glyphs cover of the samples that an encoder saw.
#pragma once

#include <filesystem>
#include <map>
#include <unordered_map>

#include "encoders/evidence.h"
#include "encoders/fit/atlas.h"

namespace rtb {

/// The footprints of all samples of a cell, as masks of glyphs. Immutable once
/// made.
class SampledMasks {
 public:
  /// @param samples of the evidence; must outlive the masks.
  /// @param glyphs all that will be asked for, and whose coverage is theirs.
  /// @param font none: geometric masks.
  static Result<SampledMasks> Make(
      const Evidence& evidence, const SamplesByCell& samples,
      const std::map<char32_t, char32_t>& glyphs,
      const std::optional<std::filesystem::path>& font);

  /// The mask of a glyph over the samples of one cell, in their order.
  /// @param storage where it is built unless all cells share one pattern.
  const FitMask& Of(char32_t glyph, int cell, FitMask& storage) const;

 private:
  explicit SampledMasks(const SamplesByCell& samples) : samples_(samples) {}

  FitMask Build(char32_t glyph, int cell) const;

  const SamplesByCell& samples_;
  bool shared_ = false;  ///< All cells have the same samples.
  std::unordered_map<char32_t, Mask> fine_;
  std::unordered_map<char32_t, FitMask> masks_;  ///< When shared.
};

}  // namespace rtb
