// `temporal`: cells that noise alone would change stay, others do not.
#include "encoders/modifiers/temporal.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "core/math/random.h"
#include "encoders/decode.h"
#include "encoders/modifiers/drift.h"
#include "tests/encoders/picture_source.h"
#include "tests/encoders/testing.h"

namespace rtb {
namespace {

// sigma 0.1, z 2, 16 partitions: d = 8 for the mask alone, 0.01 (8 + 2
// sqrt(16))
// + 2 2 0.1 sqrt(0.25) = 0.36; d = 20 for the cell, 0.01 (20 + 2 8) + 0.2.
TEST(StabilityTest, MarginsAreTheirDefinition) {
  const StabilityTest test{2, 0.1, 16};
  EXPECT_NEAR(test.MaskMargin(0.25), 0.36, 1e-12);
  EXPECT_NEAR(test.CellMargin(0.25), 0.56, 1e-12);
  // One partition: no degrees of freedom but the colors'.
  EXPECT_DOUBLE_EQ((StabilityTest{3, 0.1, 1}).MaskMargin(0), 0);
}

// A step of 4/100 everywhere, beside a noise of 3/100 a cell: not to be told in
// one cell, but in 25.
TEST(FindDrift, SeesInManyCellsWhatOneCannotTell) {
  const MeanChange change{V3d(0.01), 9e-4 / 4};
  EXPECT_EQ(FindDrift({1, 1}, {change}), std::vector<bool>{false});
  const std::vector<bool> drifted =
      FindDrift({9, 9}, std::vector<MeanChange>(81, change));
  // 81 cells: 3 (81 / 100)^2 = 1.97 against 16.27 81 9e-4 = 1.19. In 3 x 3:
  // 3 (9 / 100)^2 = 0.024 against 0.132; with four times the step 0.39.
  EXPECT_TRUE(drifted[40]);
  EXPECT_FALSE(FindDrift({3, 3}, std::vector<MeanChange>(9, change))[4]);
  const MeanChange more{V3d(0.04), 9e-4 / 4};
  EXPECT_TRUE(FindDrift({3, 3}, std::vector<MeanChange>(9, more))[4]);
  // 3 0.04^2 = 0.0048 against 16.27 9e-4 = 0.0146: not in one cell.
  EXPECT_FALSE(FindDrift({1, 1}, {more})[0]);
}

// One row of nine moves, as an edge would: its own cells tell.
TEST(FindDrift, SeesALineThatMoves) {
  const MeanChange still{V3d(0), 9e-4 / 4};
  std::vector<MeanChange> changes(81, still);
  // 3 (5 0.05)^2 = 0.1875 in the line is more than 0.0732, in 25 cells less
  // than 0.366, and 3 (9 0.05)^2 = 0.61 in 81 cells less than 1.19.
  for (std::size_t column = 0; column < 9; ++column) {
    changes[4 * 9 + column].change = V3d(0.05);
  }
  const std::vector<bool> drifted = FindDrift({9, 9}, changes);
  EXPECT_TRUE(drifted[40]);
  EXPECT_FALSE(drifted[40 + 9]);
}

/// A disk on a gradient, moved by `shift` cells, with Gaussian noise of
/// standard deviation `sigma` on the encoded values (Box and Muller).
Picture NoisyDisk(double sigma, std::uint64_t seed, double shift = 0) {
  return [=](double x, double y, int channel) {
    const double moved = x - shift;
    const double far = std::hypot(moved - 20, 2 * (y - 9));
    const double clean = far < 11 ? 0.75 - 0.02 * channel * far
                                  : 0.2 + 0.01 * moved + 0.1 * channel;
    const auto place = static_cast<std::uint32_t>(std::lround(x * 512));
    const auto line = static_cast<std::uint32_t>(std::lround(y * 512));
    const auto unit = [&](int i) {
      return UnitFloat(RandomBits(
          place, line, static_cast<std::uint32_t>(2 * channel + i), seed));
    };
    const double noise = std::sqrt(-2 * std::log(1 - unit(0))) *
                         std::cos(6.28318530718 * double{unit(1)});
    return SrgbDecode(static_cast<float>(clean + sigma * noise));
  };
}

constexpr GridSize kGrid{40, 18};

CellGrid EncodeAfter(const std::string& spec, const Picture& picture,
                     const CellGrid* previous) {
  PictureSource source(picture);
  EncodeContext context;
  context.previous = previous;
  auto encoding = Make(spec)->Run(source, kGrid, 0.5, context);
  EXPECT_TRUE(encoding);
  return std::move(encoding->grid);
}

struct Changes {
  double glyphs = 0;
  double cells = 0;
};

/// Shares of cells whose glyph, or anything, differs.
Changes Compare(const CellGrid& a, const CellGrid& b) {
  Changes changes;
  for (std::size_t i = 0; i < a.cells.size(); ++i) {
    changes.glyphs += a.cells[i].glyph != b.cells[i].glyph;
    changes.cells += a.cells[i] != b.cells[i];
  }
  const auto count = static_cast<double>(a.cells.size());
  return {changes.glyphs / count, changes.cells / count};
}

/// Mean squared error of a grid's look against a picture without noise.
double ErrorAgainst(const CellGrid& grid, const Picture& picture) {
  const auto image = Decode(grid, {});
  EXPECT_TRUE(image);
  double sum = 0;
  for (int y = 0; y < image->height(); ++y) {
    for (int x = 0; x < image->width(); ++x) {
      for (int c = 0; c < 3; ++c) {
        const float truth =
            SrgbEncode(picture((x + 0.5) / 8, (y + 0.5) / 16, c));
        sum += std::pow(double{image->at(x, y)[c] - truth}, 2);
      }
    }
  }
  return sum / (3.0 * image->width() * image->height());
}

constexpr double kSigma = 6.0 / 255;

class EveryStableEncoder : public testing::TestWithParam<const char*> {
 protected:
  std::string Stable() const {
    return std::string(GetParam()) + ":temporal=3:sigma=6";
  }
};

// Two renders of one frame that differ in their noise alone.
TEST_P(EveryStableEncoder, KeepsCellsThatDifferByNoise) {
  const CellGrid first = EncodeAfter(Stable(), NoisyDisk(kSigma, 1), nullptr);
  const Picture again = NoisyDisk(kSigma, 2);
  const CellGrid second = EncodeAfter(Stable(), again, &first);
  const Changes changes = Compare(first, second);
  EXPECT_LT(changes.glyphs, 0.01);
  EXPECT_LT(changes.cells, 0.03);
  // Without it most cells change, or the test would show nothing.
  EXPECT_GT(Compare(first, EncodeAfter(GetParam(), again, nullptr)).cells, 0.5);
}

/// Answers with a variance for every sample, as several rays a sample do.
class KnownNoise : public PictureSource {
 public:
  KnownNoise(Picture picture, double sigma)
      : PictureSource(std::move(picture)), sigma_(sigma) {}

  Result<Fragments> Query(const SamplePlan& plan) override {
    RTB_ASSIGN_OR_RETURN(Fragments fragments, PictureSource::Query(plan));
    for (const Rgb& value : fragments.values) {
      const float gray = (value.x + value.y + value.z) / 3;
      const double slope = SrgbEncode(std::min(gray, 0.999f) + 1e-3f) / 1e-3 -
                           SrgbEncode(std::min(gray, 0.999f)) / 1e-3;
      fragments.variances.push_back(
          static_cast<float>(std::pow(sigma_ / slope, 2)));
    }
    return fragments;
  }

 private:
  double sigma_;
};

// Without `sigma`, the renderer says how large the noise is.
TEST_P(EveryStableEncoder, TakesTheNoiseFromTheRenderer) {
  const std::string spec = std::string(GetParam()) + ":temporal=3";
  const CellGrid first = EncodeAfter(GetParam(), NoisyDisk(kSigma, 1), nullptr);
  EncodeContext context;
  context.previous = &first;
  KnownNoise source(NoisyDisk(kSigma, 2), kSigma);
  const auto second = Make(spec)->Run(source, kGrid, 0.5, context);
  ASSERT_TRUE(second);
  EXPECT_LT(Compare(first, second->grid).cells, 0.06);
}

// At most 0.1 dB behind the same encoder without memory: a factor of 1.0233.
TEST_P(EveryStableEncoder, LosesNoQuality) {
  const CellGrid first = EncodeAfter(Stable(), NoisyDisk(kSigma, 1), nullptr);
  const Picture again = NoisyDisk(kSigma, 2);
  const Picture clean = NoisyDisk(0, 0);
  EXPECT_LT(
      ErrorAgainst(EncodeAfter(Stable(), again, &first), clean),
      1.0233 * ErrorAgainst(EncodeAfter(GetParam(), again, nullptr), clean));
}

// A pixel (an eighth of a cell) a frame: no ghosts are left behind.
TEST_P(EveryStableEncoder, FollowsAPan) {
  CellGrid stable;
  double stable_error = 0;
  double free_error = 0;
  for (int frame = 0; frame < 12; ++frame) {
    const auto seed = static_cast<std::uint64_t>(frame);
    const Picture picture = NoisyDisk(kSigma, seed, frame / 8.0);
    const Picture clean = NoisyDisk(0, 0, frame / 8.0);
    stable = EncodeAfter(Stable(), picture, frame == 0 ? nullptr : &stable);
    stable_error += ErrorAgainst(stable, clean);
    free_error +=
        ErrorAgainst(EncodeAfter(GetParam(), picture, nullptr), clean);
  }
  EXPECT_LT(stable_error, 1.0233 * free_error);
}

INSTANTIATE_TEST_SUITE_P(
    , EveryStableEncoder,
    testing::Values("half", "quadrant", "quadrant:split=best", "search", "tiv",
                    "sextant", "octant", "braille", "optimal:mask=4x8",
                    "adaptive"),
    [](const auto& test) {
      std::string name = test.param;
      std::ranges::replace_if(
          name, [](char c) { return std::isalnum(c) == 0; }, '_');
      return name;
    });

// Without noise a cell that fits less well is replaced at once. (Where a glyph
// is as good but for the rounding of its colors, it may stay.)
TEST(Temporal, ReplacesEverythingWithoutNoise) {
  const Picture now = NoisyDisk(kSigma, 2);
  const CellGrid first =
      EncodeAfter("octant:temporal=3:sigma=0", NoisyDisk(kSigma, 1), nullptr);
  const CellGrid second = EncodeAfter("octant:temporal=3:sigma=0", now, &first);
  EXPECT_LT(Compare(second, EncodeAfter("octant", now, nullptr)).glyphs, 0.02);
  EXPECT_GT(Compare(second, first).cells, 0.98);
}

// A last frame of another size says nothing.
TEST(Temporal, IgnoresAFrameOfAnotherSize) {
  const CellGrid small({3, 2});
  EXPECT_EQ(EncodeAfter("octant:temporal=3:sigma=255", NoisyDisk(0, 0), &small),
            EncodeAfter("octant", NoisyDisk(0, 0), nullptr));
}

}  // namespace
}  // namespace rtb
