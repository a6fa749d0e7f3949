/// @file
/// The bodies of the kernels that encode cells on a GPU, one call a thread.
/// They give the cells of the encoders of the same names with their default
/// parameters, by the same lines of host and device code.
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/base/host_device.h"
#include "core/color/srgb_scalar.h"
#include "core/math/vec.h"
#include "encoders/cell.h"
#include "encoders/partition_cell.h"
#include "encoders/steps.h"
#include "encoders/tiv_scalar.h"

namespace rtb {

/// The tables of host memory that encoders look things up in, copied.
struct EncodeTables {
  const SrgbCodeTable* codes = nullptr;
  const SrgbCurveTable* curve = nullptr;
  /// Of each mask of "on" samples; null for tiv, which has its own table.
  const char32_t* glyphs = nullptr;
  const TivGlyph* tiv_glyphs = nullptr;  ///< kTivGlyphs, for tiv.
};

/// What the kernels that encode are given. All pointers are the device's.
struct EncodeJob {
  const Rgb* samples = nullptr;  ///< Linear radiance, cell by cell.
  float gain = 1;                ///< Exposure: multiplies them.
  int samples_per_cell = 0;
  std::size_t cell_count = 0;
  EncodeTables tables;
  Cell* cells = nullptr;
};

/// A sample's color as 8-bit codes.
RTB_HD inline Rgb8 CodesOf(const EncodeJob& job, const Rgb& sample) {
  const SrgbCodeTable& table = *job.tables.codes;
  const Rgb color = sample * job.gain;
  return {SrgbCodeBy(table, color.x), SrgbCodeBy(table, color.y),
          SrgbCodeBy(table, color.z)};
}

/// A sample's color in steps.
RTB_HD inline StepColor StepsOf(const EncodeJob& job, const Rgb& sample) {
  const SrgbCurveTable& table = *job.tables.curve;
  const Rgb color = sample * job.gain;
  return {EncodedStepsBy(table, color.x), EncodedStepsBy(table, color.y),
          EncodedStepsBy(table, color.z)};
}

/// Encoder half: the lower sample's color on the upper's. Its one glyph is the
/// first of the table.
RTB_HD inline void EncodeHalfCell(const EncodeJob& job, std::size_t index) {
  if (index >= job.cell_count) return;
  const Rgb* samples = job.samples + 2 * index;
  job.cells[index] = {job.tables.glyphs[0], CodesOf(job, samples[1]),
                      CodesOf(job, samples[0])};
}

/// Encoder quadrant.
RTB_HD inline void EncodeQuadrantCell(const EncodeJob& job, std::size_t index) {
  if (index >= job.cell_count) return;
  V3d encoded[4] = {V3d(0), V3d(0), V3d(0), V3d(0)};
  for (int i = 0; i < 4; ++i) {
    encoded[i] = FromSteps(
        StepsOf(job, job.samples[4 * index + static_cast<std::size_t>(i)]));
  }
  const SampleMask on = BrighterThanMean(encoded);
  job.cells[index] =
      CellOfMeansBy(SrgbCodes8{}, encoded, 4, on, job.tables.glyphs[on]);
}

/// Encoders sextant and octant: the best partition of 6 or 8 samples.
RTB_HD inline void EncodePartitionCell(const EncodeJob& job,
                                       std::size_t index) {
  if (index >= job.cell_count) return;
  const auto count = static_cast<std::size_t>(job.samples_per_cell);
  StepColor steps[kMaxPartitionSamples];
  V3d encoded[kMaxPartitionSamples];
  for (std::size_t i = 0; i < count; ++i) {
    steps[i] = StepsOf(job, job.samples[count * index + i]);
    encoded[i] = FromSteps(steps[i]);
  }
  const SampleMask best = BestPartitionOfSteps(steps, count);
  const SampleMask on = BrighterSideBy(SrgbAsIs{}, encoded, count, best);
  job.cells[index] =
      CellOfMeansBy(SrgbCodes8{}, encoded, count, on, job.tables.glyphs[on]);
}

/// Encoder tiv.
RTB_HD inline void EncodeTivCell(const EncodeJob& job, std::size_t index) {
  if (index >= job.cell_count) return;
  const Rgb* samples = job.samples + kTivPixels * index;
  std::uint32_t pixels[kTivPixels];
  for (int i = 0; i < kTivPixels; ++i) {
    pixels[i] = PackedColor(CodesOf(job, samples[i]));
  }
  job.cells[index] = TivCellBy(job.tables.tiv_glyphs, pixels);
}

}  // namespace rtb
