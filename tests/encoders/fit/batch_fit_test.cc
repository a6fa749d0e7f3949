#include "encoders/fit/batch_fit.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/image/io.h"
#include "encoders/fit/fit.h"
#include "encoders/glyphs/glyph_lists.h"
#include "tests/encoders/testing.h"
#include "tests/simd_targets.h"

namespace rtb {
namespace {

/// The linear pixels of a picture, cell by cell.
std::vector<Rgb> CellsOf(const Image& image, int width, int height) {
  std::vector<Rgb> values;
  for (int top = 0; top + height <= image.height(); top += height) {
    for (int left = 0; left + width <= image.width(); left += width) {
      for (int i = 0; i < width * height; ++i) {
        values.push_back(image.at(left + i % width, top + i / width));
      }
    }
  }
  return values;
}

struct Picture8 {
  std::string file;
  std::string glyphs;
  int width, height;
};

// Real pictures, with flat parts, edges, gradients and noise, all of whole
// codes: every cell is the scalar one.
TEST(BatchFitTest, GivesTheCellsOfFitCellOnPictures) {
  const Picture8 kPictures[] = {
      {"tiv/gradient.png", "blocks+quadrants+eighths", 8, 8},
      {"metrics/spheres.png", "blocks+quadrants+eighths", 8, 16},
      {"metrics/noise.png", "blocks+quadrants+eighths+shades", 4, 8},
      {"metrics/spheres.png", "eighths+sextants+octants+wedges", 8, 16},
      {"metrics/blur.png", "ascii", 8, 16}};
  for (const Picture8& picture : kPictures) {
    SCOPED_TRACE(picture.file + " " + picture.glyphs);
    const auto image = ReadLinear(std::string(RTB_TEST_SOURCE_DIR) +
                                  "/tests/data/" + picture.file);
    ASSERT_TRUE(image) << image.error().ToString();
    const auto atlas =
        MakeAtlas(*GlyphsOf(picture.glyphs), picture.width, picture.height);
    ASSERT_TRUE(atlas) << atlas.error().ToString();
    const auto values = CellsOf(*image, picture.width, picture.height);
    const auto count = static_cast<std::size_t>(picture.width * picture.height);
    std::vector<Cell> expected;
    for (std::size_t i = 0; i < values.size(); i += count) {
      std::vector<V3d> samples(count);
      ToBlend(Blend::kSrgb, std::span(values).subspan(i, count), samples);
      expected.push_back(FitCell(*atlas, Blend::kSrgb, samples).cell);
    }
    const BatchFit batch(*atlas);
    ForEachSimdTarget([&] {
      std::vector<Cell> cells(expected.size());
      batch.Fit(values, cells);
      EXPECT_EQ(std::ranges::mismatch(cells, expected).in1, cells.end());
    });
  }
}

// More samples than the vector code holds: every cell is fitted by itself.
TEST(BatchFitTest, TakesMasksOfAnySize) {
  const auto atlas = MakeAtlas(*GlyphsOf("blocks"), 16, 16);
  ASSERT_TRUE(atlas);
  const auto values = RandomValues(3 * 256, 1);
  std::vector<Cell> cells(3);
  BatchFit(*atlas).Fit(values, cells);
  std::vector<V3d> samples(256);
  ToBlend(Blend::kSrgb, std::span(values).last(256), samples);
  EXPECT_EQ(cells[2], FitCell(*atlas, Blend::kSrgb, samples).cell);
}

}  // namespace
}  // namespace rtb
