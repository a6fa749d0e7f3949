// The bodies of the encoding kernels, run on the CPU for every thread: they
// give the cells of the encoders.
#include "encoders/cuda/encode_kernels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <ostream>
#include <string>
#include <vector>

#include "encoders/glyphs/patterns.h"
#include "tests/encoders/cuda/varied_samples.h"
#include "tests/encoders/testing.h"

namespace rtb {
namespace {

using rtb::testing::JobOf;
using rtb::testing::VariedSamples;

using Body = void (*)(const EncodeJob&, std::size_t);

struct Kernel {
  std::string encoder;
  int samples;
  Body body;
  std::vector<char32_t> glyphs;
};

void PrintTo(const Kernel& kernel, std::ostream* out) {
  *out << kernel.encoder;
}

/// Runs a body for all threads of blocks of 64.
std::vector<Cell> Encode(const Kernel& kernel, const std::vector<Rgb>& samples,
                         float gain = 1) {
  std::vector<Cell> cells;
  EncodeJob job = JobOf(samples, kernel.samples, kernel.glyphs, &cells);
  job.gain = gain;
  const std::size_t threads = (cells.size() + 63) / 64 * 64;
  for (std::size_t i = 0; i < threads; ++i) kernel.body(job, i);
  return cells;
}

class EncodeKernelsTest : public ::testing::TestWithParam<Kernel> {};

TEST_P(EncodeKernelsTest, GiveTheEncodersCells) {
  const Kernel& kernel = GetParam();
  // One cell, a part of a block, and no multiple of blocks.
  for (const GridSize grid : {GridSize{1, 1}, GridSize{7, 3}, {37, 27}}) {
    const std::vector<Rgb> samples =
        VariedSamples(grid.cells(), kernel.samples);
    EXPECT_EQ(Encode(kernel, samples),
              EncodeValues(kernel.encoder, grid, samples).cells);
  }
}

TEST_P(EncodeKernelsTest, ApplyExposureFirst) {
  const Kernel& kernel = GetParam();
  constexpr GridSize kGrid{10, 4};
  const std::vector<Rgb> samples =
      RandomValues(kGrid.cells() * kernel.samples, 6);
  const auto gain = static_cast<float>(std::exp2(-0.7));
  std::vector<Rgb> exposed = samples;
  for (Rgb& value : exposed) value *= gain;
  EXPECT_EQ(Encode(kernel, samples, gain),
            EncodeValues(kernel.encoder, kGrid, exposed).cells);
}

INSTANTIATE_TEST_SUITE_P(
    Encoders, EncodeKernelsTest,
    ::testing::Values(Kernel{"half", 2, EncodeHalfCell, {U'▄'}},
                      Kernel{"quadrant", 4, EncodeQuadrantCell,
                             GlyphsOfPatterns(QuadrantGlyph, 4)},
                      Kernel{"quadrant:split=best", 4, EncodePartitionCell,
                             GlyphsOfPatterns(QuadrantGlyph, 4)},
                      Kernel{"sextant", 6, EncodePartitionCell,
                             GlyphsOfPatterns(SextantGlyph, 6)},
                      Kernel{"octant", 8, EncodePartitionCell,
                             GlyphsOfPatterns(OctantGlyph, 8)},
                      Kernel{"tiv", kTivPixels, EncodeTivCell, {}}));

}  // namespace
}  // namespace rtb
