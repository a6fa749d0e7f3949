#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <utility>

#include "encoders/decode.h"
#include "tests/encoders/picture_source.h"
#include "tests/encoders/testing.h"

namespace rtb {
namespace {

constexpr double kCellAspect = 0.5;

/// Stripes that no cell can show, finer to the right.
float Stripes(double x, double y, int channel) {
  return std::sin((x + 2) * (7 * y + 5 * x + channel)) > 0 ? 1.0f : 0.0f;
}

Encoding Encode(const std::string& spec, PictureSource& source, GridSize grid,
                const EncodeContext& context = {}) {
  const auto encoder = Make(spec);
  auto encoding = encoder->Run(source, grid, kCellAspect, context);
  EXPECT_TRUE(encoding) << encoding.error().ToString();
  return std::move(*encoding);
}

Encoding Encode(const std::string& spec, const Picture& picture,
                GridSize grid) {
  PictureSource source(picture);
  return Encode(spec, source, grid);
}

/// Samples of each cell.
std::vector<int> CountsOf(const PictureSource& source, GridSize grid) {
  std::vector<int> counts(static_cast<std::size_t>(grid.cells()));
  for (const SamplePlan& plan : source.plans()) {
    for (int entry = 0; entry < plan.entries(); ++entry) {
      counts[static_cast<std::size_t>(plan.cell(entry))] +=
          plan.samples_per_cell;
    }
  }
  return counts;
}

// All that the budget has room for is spent: 35 cells get floor(35 rays).
TEST(Adaptive, SpendsItsBudgetAndNoMore) {
  constexpr GridSize kGrid{7, 5};
  for (const char* rays : {"1", "1.5", "2", "3.7", "8", "20", "64"}) {
    PictureSource source(Stripes);
    const Encoding encoding =
        Encode(std::string("adaptive:rays=") + rays, source, kGrid);
    EXPECT_EQ(source.samples(), std::floor(std::stod(rays) * 35)) << rays;
    EXPECT_DOUBLE_EQ(encoding.rays_per_cell, source.samples() / 35) << rays;
  }
}

TEST(Adaptive, RefusesBudgetsThatItCannotSpend) {
  for (const char* rays : {"0", "0.5", "65", "many", "nan"}) {
    const auto made = MakeEncoder(std::string("adaptive:rays=") + rays);
    ASSERT_FALSE(made) << rays;
    EXPECT_EQ(made.error().place,
              std::string("encoder `adaptive:rays=") + rays + "`: rays");
  }
}

TEST(Adaptive, GivesNoCellMoreThan64) {
  constexpr GridSize kGrid{6, 4};
  // One busy cell.
  PictureSource source([](double x, double y, int channel) {
    const bool busy = x >= 2 && x < 3 && y >= 1 && y < 2;
    return busy ? Stripes(9 * x, 9 * y, channel) : 0.5f;
  });
  Encode("adaptive:rays=30", source, kGrid);
  for (const int count : CountsOf(source, kGrid)) EXPECT_LE(count, 64);
}

// Of 8 rays a cell, all but the first two go to the column of cells that the
// edge crosses, until it has what it can get in 8 rounds.
TEST(Adaptive, SendsRaysToEdges) {
  constexpr GridSize kGrid{9, 6};
  PictureSource source(
      [](double x, double y, int) { return x < 4.3 + 0.05 * y ? 0.2f : 0.7f; });
  Encode("adaptive", source, kGrid);
  const std::vector<int> counts = CountsOf(source, kGrid);
  for (int row = 0; row < kGrid.rows; ++row) {
    const auto at = [&](int column) {
      return counts[static_cast<std::size_t>(row * kGrid.columns + column)];
    };
    EXPECT_GE(at(4), 26) << row;
    EXPECT_LE(at(1), 8) << row;
    EXPECT_LE(at(7), 8) << row;
  }
}

// A random number belongs to one sample of a cell, whatever the round.
TEST(Adaptive, NumbersTheSamplesOfACell) {
  PictureSource source(Stripes);
  Encode("adaptive", source, {7, 5});
  std::set<std::pair<int, int>> seen;
  for (const SamplePlan& plan : source.plans()) {
    for (int entry = 0; entry < plan.entries(); ++entry) {
      for (int i = 0; i < plan.samples_per_cell; ++i) {
        const auto inserted =
            seen.emplace(plan.cell(entry), plan.number(entry, i));
        EXPECT_TRUE(inserted.second);
      }
    }
  }
  EXPECT_EQ(seen.size(), 7 * 5 * 8);
}

TEST(Adaptive, SeedMovesRays) {
  const auto positions = [](const std::string& spec, std::uint64_t seed) {
    PictureSource source(Stripes);
    EncodeContext context;
    context.seed = seed;
    Encode(spec, source, {7, 5}, context);
    return source.plans().back().positions;
  };
  EXPECT_EQ(positions("adaptive", 1), positions("adaptive", 1));
  EXPECT_NE(positions("adaptive", 1), positions("adaptive", 2));
  EXPECT_EQ(positions("adaptive:seed=2", 1), positions("adaptive", 2));
}

// Light left of 3/8 of the cell: the left three eighths block. A sub-pixel
// beside the edge may mix both sides. (With 40 rays it depends on the seed
// which eighth is nearest.)
TEST(Adaptive, FindsTheEdgeOfOneCell) {
  const Encoding encoding = Encode(
      "adaptive:rays=48",
      [](double x, double, int) { return x < 0.375 ? 0.5f : 0.3f; }, {1, 1});
  EXPECT_EQ(encoding.grid.cells[0].glyph, U'▍');
  EXPECT_NEAR(encoding.grid.cells[0].fg.r, SrgbEncode8(0.5f), 6);
  EXPECT_NEAR(encoding.grid.cells[0].bg.r, SrgbEncode8(0.3f), 5);
}

// A smooth slope needs no rays: the rebuilt cells follow it within 3 codes. In
// linear light 0.2 + 0.02 x is 124 to 152 in codes over 10 cells, 3 a cell.
TEST(Adaptive, FollowsGradients) {
  constexpr GridSize kGrid{10, 4};
  const auto slope = [](double x, double, int) {
    return static_cast<float>(0.2 + 0.02 * x);
  };
  const Encoding encoding = Encode("adaptive:rays=2", slope, kGrid);
  const auto image = Decode(encoding.grid, {});
  ASSERT_TRUE(image) << image.error().ToString();
  for (int x = 0; x < image->width(); ++x) {
    const float expected = SrgbEncode(slope((x + 0.5) / 8, 0, 0));
    EXPECT_NEAR(image->at(x, 20).x, expected, 3.0f / 255) << x;
  }
}

// A line of 1/16 of the height on black: the mean of the rows around it is
// not black, their median is.
TEST(Adaptive, MedianLeavesOutliersOut) {
  const auto line = [](double, double y, int) {
    return y > 0.5 && y < 0.5625 ? 0.3f : 0.0f;
  };
  const auto shown = [&](const std::string& color) {
    const Encoding encoding =
        Encode("adaptive:rays=40:glyphs=blocks:color=" + color, line, {1, 1});
    const Cell& cell = encoding.grid.cells[0];
    return std::max(cell.fg.r, cell.bg.r);
  };
  EXPECT_GT(shown("mean"), 8);
  EXPECT_EQ(shown("median"), 0);
}

TEST(Adaptive, HandsOnTheRasterThatItChoseFrom) {
  constexpr GridSize kGrid{5, 3};
  const Encoding encoding = Encode(
      "adaptive:rays=6:mask=4x8", [](double, double, int) { return 0.25f; },
      kGrid);
  ASSERT_EQ(encoding.evidence.rounds.size(), 1u);
  const SampleRound& round = encoding.evidence.rounds[0];
  EXPECT_EQ(round.plan.samples_per_cell, 32);
  EXPECT_EQ(round.fragments.values.size(), 15u * 32);
  EXPECT_DOUBLE_EQ(encoding.evidence.weight, 6.0 / 32);
  // Rounded to the nearest code.
  EXPECT_EQ(round.fragments.values[7], Decode8(Encode8(Rgb(0.25f))));
}

}  // namespace
}  // namespace rtb
