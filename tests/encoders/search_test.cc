// Encoder `search`: which edge it finds, in which colors, with which rays.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>

#include "encoders/evidence.h"
#include "tests/encoders/picture_source.h"
#include "tests/encoders/testing.h"

namespace rtb {
namespace {

/// What one search alone sees: `first` before an edge at `at` of each cell,
/// `second` beyond; the other search's rays, whose places along their strips
/// are random, see `first`.
Picture Edge(bool vertical, double at, Rgb8 first, Rgb8 second,
             int strips = 8) {
  return [=](double x, double y, int channel) {
    const double along = vertical ? y : x;
    const double strip = (along - std::floor(along)) * strips;
    const bool center = std::abs(strip - std::floor(strip) - 0.5) < 1e-6;
    return Decode8(center && strip >= at * strips ? second : first)[channel];
  };
}

Encoding RunSpec(const std::string& spec, GridSize grid, const Picture& picture,
                 std::uint64_t seed = 0) {
  PictureSource source(picture);
  EncodeContext context;
  context.seed = seed;
  auto encoding = Make(spec)->Run(source, grid, 0.5, context);
  EXPECT_TRUE(encoding);
  return std::move(*encoding);
}

constexpr Rgb8 kRed{200, 30, 40};
constexpr Rgb8 kBlue{20, 60, 180};

struct EdgeCase {
  const char* spec;
  int strips;
};

class SearchEdges : public testing::TestWithParam<EdgeCase> {};

// An edge between two strips is found exactly: each side is of one color, so
// its mean is that color. An edge after k of n strips is drawn at the nearest
// eighth: for n = 6 after 1.33, 2.67, 4, 5.33, 6.67 -> 1, 3, 4, 5, 7.
TEST_P(SearchEdges, FindsEveryEdgeBetweenStrips) {
  const int n = GetParam().strips;
  for (int k = 1; k < n; ++k) {
    const auto eighths = static_cast<char32_t>(std::lround(8.0 * k / n));
    const double at = static_cast<double>(k) / n;
    const CellGrid rows =
        RunSpec(GetParam().spec, {3, 2}, Edge(true, at, kRed, kBlue, n)).grid;
    const CellGrid columns =
        RunSpec(GetParam().spec, {3, 2}, Edge(false, at, kRed, kBlue, n)).grid;
    for (std::size_t i = 0; i < rows.cells.size(); ++i) {
      EXPECT_EQ(rows.cells[i], (Cell{0x2588 - eighths, kBlue, kRed})) << k;
      EXPECT_EQ(columns.cells[i], (Cell{0x2590 - eighths, kRed, kBlue})) << k;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    , SearchEdges,
    testing::Values(EdgeCase{"search", 8}, EdgeCase{"search:rays=12", 6},
                    EdgeCase{"search:rays=8", 4},
                    EdgeCase{"search:order=sequential", 8},
                    EdgeCase{"search:order=sequential:rays=12", 6},
                    EdgeCase{"search:order=sequential:rays=8", 4}),
    [](const auto& test) {
      std::string name = test.param.spec;
      std::ranges::replace_if(
          name, [](char c) { return std::isalnum(c) == 0; }, '_');
      return name;
    });

// Codes a and a + 2 on either side of the middle: the strength is
// (2/255)^2 * 3 channels / 4, times 255^2 = 3: not below the default `flat`.
// With a + 1 it is 0.75. The mean of half a and half a + 1 rounds up.
TEST(Search, IsASpaceWhereTheBestSplitIsWeak) {
  const Rgb8 a{100, 100, 100};
  EXPECT_EQ(
      RunSpec("search:flat=2.9", {1, 1}, Edge(true, 0.5, a, {102, 102, 102}))
          .grid.cells[0],
      (Cell{U'▄', {102, 102, 102}, a}));
  EXPECT_EQ(
      RunSpec("search:flat=3.1", {1, 1}, Edge(true, 0.5, a, {102, 102, 102}))
          .grid.cells[0]
          .glyph,
      U' ');
  EXPECT_EQ(
      RunSpec("search:flat=0.7", {1, 1}, Edge(true, 0.5, a, {101, 101, 101}))
          .grid.cells[0]
          .glyph,
      U'▄');
}

// A checker of quarters looks the same in both directions only by chance; a
// single bright quarter does so by symmetry when the rays run along strips of
// equal share: the vertical search wins the tie.
TEST(Search, TakesTheVerticalSearchOnATie) {
  // The ray of row i is bright for i >= 4, that of column i too: the same
  // strengths.
  const Picture picture = [](double x, double y, int) {
    const bool row_center = std::abs(std::fmod(y * 8, 1) - 0.5) < 1e-6;
    const double at = row_center ? y : x;
    return at - std::floor(at) < 0.5 ? 0.0f : 1.0f;
  };
  EXPECT_EQ(RunSpec("search", {1, 1}, picture).grid.cells[0].glyph, U'▄');
}

TEST(Search, TracesOneRayInEachRowAndColumn) {
  PictureSource source([](double, double, int) { return 0.5f; });
  ASSERT_TRUE(Make("search")->Run(source, {2, 1}, 0.5, {}));
  ASSERT_EQ(source.plans().size(), 1u);
  const SamplePlan& plan = source.plans()[0];
  ASSERT_EQ(plan.samples(), 32u);
  for (int cell = 0; cell < 2; ++cell) {
    std::set<float> along;
    for (int strip = 0; strip < 8; ++strip) {
      const float center = (static_cast<float>(strip) + 0.5f) / 8;
      const V2f& row = plan.position(16 * cell + strip, 0);
      const V2f& column = plan.position(16 * cell + 8 + strip, 0);
      EXPECT_EQ(row.y, center);
      EXPECT_EQ(column.x, center);
      along.insert({row.x, column.y});
    }
    EXPECT_EQ(along.size(), 16u);
  }
}

// Least squares over all rays explains a cell at least as well as the winner's
// means do, measured on the same rays.
TEST(Search, FitOfAllRaysLeavesNoMoreError) {
  const Picture picture = [](double x, double y, int channel) {
    return static_cast<float>(0.5 + 0.5 * std::sin(4 * x + 7 * y + channel));
  };
  const GridSize size{12, 9};
  const auto error = [&](const std::string& spec) {
    const Encoding encoding = RunSpec(spec, size, picture);
    const SamplesByCell samples(encoding.evidence);
    double sum = 0;
    for (int i = 0; i < size.cells(); ++i) {
      const Cell& cell = encoding.grid.cells[static_cast<std::size_t>(i)];
      const bool rows = cell.glyph < U'█';
      const auto edge = static_cast<float>(
          (rows ? U'█' - cell.glyph : 0x2590 - cell.glyph) / 8.0);
      for (const CellSample& sample : samples.cell(i)) {
        const bool first =
            (rows ? sample.position.y : sample.position.x) < edge;
        const bool fg_shows = cell.glyph != U' ' && first != rows;
        const Rgb shown = EncodedValues(fg_shows ? cell.fg : cell.bg);
        const Rgb seen(SrgbEncode(sample.linear.x), SrgbEncode(sample.linear.y),
                       SrgbEncode(sample.linear.z));
        sum += double{(shown - seen).length2()};
      }
    }
    return sum;
  };
  EXPECT_LT(error("search:fit=all:flat=0"), 0.9 * error("search:flat=0"));
}

TEST(Search, SeedsMoveTheRays) {
  const Picture picture = [](double x, double y, int channel) {
    return static_cast<float>(0.5 + 0.5 * std::sin(9 * x + 23 * y + channel));
  };
  const GridSize grid{8, 4};
  const CellGrid zero = RunSpec("search", grid, picture).grid;
  EXPECT_EQ(RunSpec("search:seed=0", grid, picture, 5).grid, zero);
  EXPECT_EQ(RunSpec("search:seed=5", grid, picture).grid,
            RunSpec("search", grid, picture, 5).grid);
  EXPECT_NE(RunSpec("search", grid, picture, 5).grid, zero);
}

// In the sequential order an edge after the 4th of 8 rows needs row 6 and then
// 5 beside rows 1, 8 and 4; one after the 1st row, row 2 alone.
TEST(Search, SequentialOrderCountsItsRays) {
  const std::string spec = "search:order=sequential";
  const auto rays = [&](double at) {
    // No edge between the columns: the first half of equal ones is bisected,
    // which takes row (here column) 2 and then 3.
    return RunSpec(spec, {4, 4}, Edge(true, at, kRed, kBlue)).rays_per_cell;
  };
  EXPECT_DOUBLE_EQ(rays(0.5), 5 + 4);
  EXPECT_DOUBLE_EQ(rays(0.125), 4 + 4);
  const Picture noise = [](double x, double y, int channel) {
    return static_cast<float>(
        0.5 + 0.5 * std::sin(1e4 * x + 2e4 * y * y + 31 * channel));
  };
  EXPECT_LE(RunSpec(spec, {20, 20}, noise).rays_per_cell, 10);
}

/// The squared error that a split into two sides leaves among gray values.
double ErrorAround(const std::vector<double>& first,
                   const std::vector<double>& second) {
  double error = 0;
  for (const auto* side : {&first, &second}) {
    double sum = 0;
    for (const double value : *side) sum += value;
    for (const double value : *side) {
      error += std::pow(value - sum / static_cast<double>(side->size()), 2);
    }
  }
  return error;
}

// By the definition: of a search's 7 splits the one of least error within its
// sides, drawn from rays whose values are known.
TEST(Search, TakesTheSplitOfLeastErrorOfTheWinner) {
  const Picture picture = [](double x, double y, int) {
    return static_cast<float>(
        0.5 + 0.45 * std::sin(5.1 * x * y + 3 * x + 1.7 * y * y));
  };
  PictureSource source(picture);
  const GridSize size{9, 7};
  const auto encoding = Make("search:flat=0")->Run(source, size, 0.5, {});
  ASSERT_TRUE(encoding);
  const SampleRound& round = encoding->evidence.rounds[0];
  for (int cell = 0; cell < size.cells(); ++cell) {
    double least = 1e9;
    char32_t glyph = 0;
    double strongest = -1;
    for (const bool vertical : {true, false}) {
      std::vector<double> values;
      for (int i = 0; i < 8; ++i) {
        const auto at =
            static_cast<std::size_t>(16 * cell + (vertical ? 0 : 8) + i);
        values.push_back(double{SrgbEncode(round.fragments.values[at].x)});
      }
      const double whole = ErrorAround(values, {});
      for (int k = 1; k < 8; ++k) {
        const double error = ErrorAround({values.begin(), values.begin() + k},
                                         {values.begin() + k, values.end()});
        // Within a search least error, between them the strongest split.
        if (whole - error > strongest + 1e-9) {
          strongest = whole - error;
          least = error;
          const auto eighths = static_cast<char32_t>(k);
          glyph = vertical ? 0x2588 - eighths : 0x2590 - eighths;
        }
      }
    }
    EXPECT_LT(least, 1e9);
    EXPECT_EQ(encoding->grid.cells[static_cast<std::size_t>(cell)].glyph, glyph)
        << cell;
  }
}

}  // namespace
}  // namespace rtb
