// What every encoder draws, at every color depth, on its way through a terminal
// and against what TerminalImageViewer would print for the same cells.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <ostream>
#include <tuple>

#include "encoders/emit/emit.h"
#include "encoders/palette.h"
#include "encoders/parse/parse.h"
#include "tests/encoders/picture_source.h"
#include "tests/encoders/testing.h"

namespace rtb {
namespace {

constexpr GridSize kGrid{31, 17};

int Distance(Rgb8 a, Rgb8 b) {
  return std::abs(a.r - b.r) + std::abs(a.g - b.g) + std::abs(a.b - b.b);
}

Rgb8 Nearest(Rgb8 color, ColorDepth depth) {
  const auto palette = PaletteColors(depth);
  if (palette.empty()) return color;
  return *std::ranges::min_element(
      palette, {}, [&](Rgb8 other) { return Distance(color, other); });
}

/// The grid in the colors of a depth.
CellGrid Quantized(CellGrid grid, ColorDepth depth) {
  for (Cell& cell : grid.cells) {
    const bool mono = depth == ColorDepth::kMono;
    cell.fg = mono ? kDefaultForeground : Nearest(cell.fg, depth);
    cell.bg = mono ? kDefaultBackground : Nearest(cell.bg, depth);
  }
  return grid;
}

/// Bytes of the sequence that sets one color.
std::size_t ColorSize(Rgb8 color, bool background, ColorDepth depth) {
  const auto digits = [](int number) { return std::to_string(number).size(); };
  switch (depth) {
    case ColorDepth::kTruecolor:  // ESC [ 38;2; r ; g ; b m
      return 10 + digits(color.r) + digits(color.g) + digits(color.b);
    case ColorDepth::k256:  // ESC [ 38;5; index m
      return 8 + digits(*IndexOf(color, depth));
    case ColorDepth::k16:  // ESC [ 30 m, and 100 for bright backgrounds.
      return background && *IndexOf(color, depth) >= 8 ? 6 : 5;
    default:
      return 0;
  }
}

/// Bytes that tiv 1.3 prints, with the palettes that it lacks too: each color
/// that differs from the cell's before it in a sequence of its own, both at
/// each line's beginning, ESC [ 0 m and LF at its end.
std::size_t TivSize(const CellGrid& grid, ColorDepth depth) {
  std::size_t size = 0;
  for (int row = 0; row < grid.size.rows; ++row) {
    std::optional<Cell> last;
    for (int column = 0; column < grid.size.columns; ++column) {
      const Cell& cell = grid.at(column, row);
      if (!last || last->fg != cell.fg)
        size += ColorSize(cell.fg, false, depth);
      if (!last || last->bg != cell.bg) size += ColorSize(cell.bg, true, depth);
      size += Utf8(cell.glyph).size();
      last = cell;
    }
    size += 5;
  }
  return size;
}

/// An encoder of the registry, and a depth.
using Way = std::tuple<std::string, ColorDepth>;

class EveryEncoderAnsi : public testing::TestWithParam<Way> {};

TEST_P(EveryEncoderAnsi, ComesBackTheSameAndIsSmall) {
  const auto& [name, depth] = GetParam();
  PictureSource source([](double x, double y, int channel) {
    return static_cast<float>(
        0.5 + 0.6 * std::sin((0.31 + 0.2 * channel) * x + 0.47 * y * x / 9));
  });
  auto encoding = Make(name)->Run(source, kGrid, 0.5, {});
  ASSERT_TRUE(encoding) << encoding.error().ToString();
  const CellGrid grid = Quantized(encoding->grid, depth);
  const std::string ansi = EmitAnsi(grid, depth);
  const auto parsed = ParseAnsi(ansi, kGrid);
  ASSERT_TRUE(parsed) << parsed.error().ToString();
  EXPECT_EQ(Canonical(*parsed), Canonical(grid));
  EXPECT_LT(ansi.size(), TivSize(grid, depth));
  RecordProperty("percent_of_tiv",
                 static_cast<int>(100 * ansi.size() / TivSize(grid, depth)));
}

std::vector<std::string> EncoderNames() {
  std::vector<std::string> names;
  const auto specs = ParseEncoderSpecs("all");
  for (const EncoderSpec& spec : *specs) {
    names.push_back(spec.name);
  }
  return names;
}

INSTANTIATE_TEST_SUITE_P(
    , EveryEncoderAnsi,
    testing::Combine(testing::ValuesIn(EncoderNames()),
                     testing::Values(ColorDepth::kTruecolor, ColorDepth::k256,
                                     ColorDepth::k16, ColorDepth::kMono)),
    [](const auto& test) {
      return std::get<0>(test.param) + "_" + NameOf(std::get<1>(test.param));
    });

}  // namespace
}  // namespace rtb
