#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <span>

#include "tests/encoders/testing.h"

namespace rtb {
namespace {

V3d Mean(const std::vector<V3d>& samples, unsigned side) {
  V3d sum(0);
  double count = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if ((side >> i & 1) == 0) continue;
    sum += samples[i];
    count += 1;
  }
  return count > 0 ? sum / count : sum;
}

/// Squared error of the samples around the means of the two sides.
double PartitionError(const std::vector<V3d>& samples, unsigned on) {
  const V3d means[] = {Mean(samples, ~on), Mean(samples, on)};
  double error = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    error += (samples[i] - means[on >> i & 1]).length2();
  }
  return error;
}

void ExpectBest(const std::vector<V3d>& samples, const Cell& cell, Blend blend,
                char32_t (*glyph)(unsigned)) {
  const unsigned patterns = 1u << samples.size();
  unsigned chosen = 0;
  double least = std::numeric_limits<double>::infinity();
  for (unsigned on = 0; on < patterns; ++on) {
    if (glyph(on) == cell.glyph) chosen = on;
    least = std::min(least, PartitionError(samples, on));
  }
  ASSERT_EQ(glyph(chosen), cell.glyph);
  EXPECT_NEAR(PartitionError(samples, chosen), least, 1e-9);
  EXPECT_EQ(cell.bg, ToRgb8(blend, Mean(samples, ~chosen)));
  EXPECT_EQ(cell.fg, ToRgb8(blend, Mean(samples, chosen)));
}

}  // namespace

void ExpectBestPartitions(const std::string& spec, int samples, Blend blend,
                          char32_t (*glyph)(unsigned)) {
  const std::vector<Rgb> linear = RandomValues(1000 * samples, 3);
  const CellGrid grid = EncodeValues(spec, {40, 25}, linear);
  const auto count = static_cast<std::size_t>(samples);
  std::vector<V3d> blended(count, V3d(0));
  for (std::size_t cell = 0; cell < grid.cells.size(); ++cell) {
    ToBlend(blend, std::span(linear).subspan(cell * count, count), blended);
    ExpectBest(blended, grid.cells[cell], blend, glyph);
  }
}

}  // namespace rtb
