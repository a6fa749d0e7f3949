// The encoding kernels as nvcc compiles them give the encoders' cells.
#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <vector>

#include "encoders/cuda/encode_kernels.h"
#include "encoders/glyphs/patterns.h"
#include "encoders/registry.h"
#include "tests/encoders/cuda/varied_samples.h"
#include "tests/encoders/given_source.h"
#include "tests/ptx/ptx_launch.h"

extern "C" {
void ptx_rtb_encode_half(unsigned char* job);
void ptx_rtb_encode_quadrant(unsigned char* job);
void ptx_rtb_encode_partition(unsigned char* job);
void ptx_rtb_encode_tiv(unsigned char* job);
}

namespace rtb {
namespace {

struct Kernel {
  std::string encoder;
  int samples;
  void (*kernel)(unsigned char*);
  std::vector<char32_t> glyphs;
};

void PrintTo(const Kernel& kernel, std::ostream* out) {
  *out << kernel.encoder;
}

class PtxCellsTest : public ::testing::TestWithParam<Kernel> {};

TEST_P(PtxCellsTest, AreTheEncoders) {
  const Kernel& kernel = GetParam();
  constexpr GridSize kGrid{23, 11};
  const std::vector<Rgb> samples =
      testing::VariedSamples(kGrid.cells(), kernel.samples);
  std::vector<Cell> cells;
  const EncodeJob job =
      testing::JobOf(samples, kernel.samples, kernel.glyphs, &cells);
  testing::LaunchPtx(kernel.kernel, job, cells.size());
  GivenSource source(samples);
  const auto encoder = MakeEncoder(kernel.encoder).value();
  EXPECT_EQ(cells, encoder->Run(source, kGrid, 0.5, {})->grid.cells);
}

INSTANTIATE_TEST_SUITE_P(
    Encoders, PtxCellsTest,
    ::testing::Values(Kernel{"half", 2, ptx_rtb_encode_half, {U'\u2584'}},
                      Kernel{"quadrant", 4, ptx_rtb_encode_quadrant,
                             GlyphsOfPatterns(QuadrantGlyph, 4)},
                      Kernel{"sextant", 6, ptx_rtb_encode_partition,
                             GlyphsOfPatterns(SextantGlyph, 6)},
                      Kernel{"octant", 8, ptx_rtb_encode_partition,
                             GlyphsOfPatterns(OctantGlyph, 8)},
                      Kernel{"tiv", kTivPixels, ptx_rtb_encode_tiv, {}}),
    [](const auto& kernel) { return kernel.param.encoder; });

}  // namespace
}  // namespace rtb
