/// @file
/// CellJudge: the modifiers that look at one cell's samples again, `color` and
/// `temporal`.
#pragma once

#include <optional>

#include "encoders/cell.h"
#include "encoders/color_depth.h"
#include "encoders/fit/palette_fit.h"
#include "encoders/modifiers/drift.h"
#include "encoders/modifiers/modifiers.h"
#include "encoders/modifiers/sampled_masks.h"

namespace rtb {

/// What a judgement depends on beside the cell and its samples.
struct JudgeOptions {
  Modifiers modifiers;
  ColorDepth depth = ColorDepth::kTruecolor;
  double weight = 1;      ///< Evidence::weight.
  double noise = 1;       ///< Evidence::noise.
  double partitions = 1;  ///< Masks, complements apart, that may be chosen.
};

/// Safe to share between threads.
class CellJudge {
 public:
  /// The references must outlive the judge.
  CellJudge(const JudgeOptions& options, const SamplesByCell& samples,
            const SampledMasks& masks);

  /// The cell with its modifiers applied.
  /// @param last the same cell of the last frame, or nullptr.
  /// @param drifted what FindDrift says of it.
  Cell Choose(int index, const Cell& cell, const Cell* last,
              bool drifted) const;

  /// How the mean of what a cell shows has changed.
  MeanChange ChangeOf(int index, const Cell& cell, const Cell& last) const;

 private:
  /// Standard deviation of the noise of one value of a cell's evidence.
  double Noise(int index) const;
  V3d MeanShown(int index, const Cell& cell) const;
  Cell Refit(const Cell& cell, const FitMask& mask,
             std::span<const V3d> samples) const;
  /// With median colors, of the palette where there is one.
  Cell Recolor(const Cell& cell, const FitMask& mask,
               std::span<const V3d> samples) const;

  JudgeOptions options_;
  const SamplesByCell& samples_;
  const SampledMasks& masks_;
  std::optional<FitPalette> palette_;  ///< Where colors have indices.
};

/// Standard deviation of the noise of a cell's samples in the blend space:
/// what their variances in linear light become by the slope of the transfer.
double NoiseOf(Blend blend, std::span<const CellSample> samples);

}  // namespace rtb
