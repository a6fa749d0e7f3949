// Every vector instruction set finds what plain loops over the slots do, bit
// for bit.
#include "encoders/adaptive/slot_kernels.h"

#include <gtest/gtest.h>

#include "tests/encoders/plain_slots.h"
#include "tests/simd_targets.h"

namespace rtb {
namespace {

constexpr float kCellWidth = 8;
constexpr float kLeast = 1e-6f;

float Unit(std::size_t index, std::uint32_t dimension) {
  return UnitFloat(
      RandomBits(static_cast<std::uint32_t>(index), dimension, 0, 9));
}

/// A grid of random slots.
struct Plane {
  static constexpr int kColumns = 5, kRows = 4;

  Plane() {
    grid.grid = {kColumns, kRows};
    grid.pitch = V2f(kCellWidth / kSlotColumns, kCellHeight / kSlotRows);
    const std::size_t count = grid.room() * kSlots;
    std::uint32_t field = 0;
    for (auto* const values : {&distance2, &r, &g, &b, &contrast, &extent}) {
      for (std::size_t i = 0; i < count; ++i) {
        values->push_back((field == 0 ? 30 : 1) * Unit(i, field));
      }
      ++field;
    }
    changed.resize(grid.room());
  }

  SlotGrid Slots() {
    grid.distance2 = distance2.data();
    grid.r = r.data();
    grid.g = g.data();
    grid.b = b.data();
    grid.contrast = contrast.data();
    grid.extent = extent.data();
    grid.changed = changed.data();
    return grid;
  }

  std::size_t Cell(int x, int y) const {
    return static_cast<std::size_t>(grid.At(x / kSlotColumns, y / kSlotRows));
  }
  static int InCell(int x, int y) {
    return y % kSlotRows * kSlotColumns + x % kSlotColumns;
  }
  /// By columns and rows of slots; up to a whole cell outside.
  std::size_t At(int x, int y) const {
    const int right = x + kSlotColumns;
    const int below = y + kSlotRows;
    return static_cast<std::size_t>(
               grid.At(right / kSlotColumns - 1, below / kSlotRows - 1)) *
               kSlots +
           static_cast<std::size_t>(InCell(right, below));
  }

  SlotGrid grid;
  std::vector<float> distance2, r, g, b, contrast, extent;
  std::vector<std::uint32_t> changed;
};

void ExpectSame(const Plane& a, const Plane& b) {
  EXPECT_EQ(a.distance2, b.distance2);
  EXPECT_EQ(a.r, b.r);
  EXPECT_EQ(a.g, b.g);
  EXPECT_EQ(a.b, b.b);
  EXPECT_EQ(a.contrast, b.contrast);
  EXPECT_EQ(a.extent, b.extent);
  EXPECT_EQ(a.changed, b.changed);
}

/// Three samples in each cell.
std::vector<SeenSample> Samples() {
  std::vector<SeenSample> samples;
  for (int i = 0; i < 3 * Plane::kColumns * Plane::kRows; ++i) {
    const auto place = static_cast<std::size_t>(i);
    samples.push_back({i / 3, V2f(Unit(place, 10), Unit(place, 11)), Rgb(0),
                       Rgb(Unit(place, 12), Unit(place, 13), Unit(place, 14))});
  }
  return samples;
}

/// From next to nothing to more than a cell.
std::vector<float> Reaches(std::size_t count) {
  std::vector<float> reaches;
  for (std::size_t i = 0; i < count; ++i) {
    reaches.push_back(0.5f + 18 * Unit(i, 15));
  }
  return reaches;
}

void PlainEnter(const SeenSample& sample, float reach, int first, int last,
                Plane& plane) {
  const int column = sample.cell % Plane::kColumns;
  const int row = sample.cell / Plane::kColumns;
  const V2f pitch = plane.grid.pitch;
  const V2f at = (V2f(static_cast<float>(column), static_cast<float>(row)) +
                  sample.position) *
                 V2f(kSlotColumns, kSlotRows);
  const auto sample_x = static_cast<int>(at.x);
  const auto sample_y = static_cast<int>(at.y);
  const auto across = static_cast<int>(std::ceil(reach / pitch.x));
  const auto down = static_cast<int>(std::ceil(reach / pitch.y));
  for (int y = first * kSlotRows; y < (last + 1) * kSlotRows; ++y) {
    for (int x = 0; x < Plane::kColumns * kSlotColumns; ++x) {
      if (std::abs(x - sample_x) > across || std::abs(y - sample_y) > down) {
        continue;
      }
      const float dx = (static_cast<float>(x) + (0.5f - at.x)) * pitch.x;
      const float dy = (static_cast<float>(y) + (0.5f - at.y)) * pitch.y;
      const std::size_t i = plane.At(x, y);
      const bool own = x == sample_x && y == sample_y;
      const bool nearer = dx * dx + dy * dy < plane.distance2[i];
      if (own || nearer) {
        plane.changed[plane.Cell(x, y)] |= 1u << Plane::InCell(x, y);
      }
      if (own) plane.extent[i] = WithOneMore(plane.extent[i]);
      if (!nearer) continue;
      plane.distance2[i] = dx * dx + dy * dy;
      plane.r[i] = sample.encoded.x;
      plane.g[i] = sample.encoded.y;
      plane.b[i] = sample.encoded.z;
    }
  }
}

TEST(SlotKernels, EnterSamplesIntoRowsAndNowhereElse) {
  const std::vector<SeenSample> samples = Samples();
  const std::vector<float> reaches = Reaches(samples.size());
  for (const int first : {0, 1, 3}) {
    for (int last = first; last < Plane::kRows; ++last) {
      Plane expected;
      for (std::size_t i = 0; i < samples.size(); ++i) {
        PlainEnter(samples[i], reaches[i], first, last, expected);
      }
      ASSERT_NE(expected.r, Plane().r);
      ForEachSimdTarget([&] {
        Plane plane;
        EnterSamples(samples, reaches, first, last, plane.Slots());
        ExpectSame(plane, expected);
      });
    }
  }
}

/// Squared distance of the colors of two slots.
float Apart(const Plane& plane, std::size_t i, std::size_t j) {
  const float dr = plane.r[i] - plane.r[j];
  const float dg = plane.g[i] - plane.g[j];
  const float db = plane.b[i] - plane.b[j];
  return dr * dr + dg * dg + db * db;
}

/// The contrasts of one cell and its best gain.
float PlainCompare(int column, int row, bool root, Plane& plane) {
  float best = 0;
  for (int slot = 0; slot < kSlots; ++slot) {
    const int x = column * kSlotColumns + slot % kSlotColumns;
    const int y = row * kSlotRows + slot / kSlotColumns;
    const std::size_t i = plane.At(x, y);
    float contrast =
        std::max(Apart(plane, plane.At(x - 1, y), plane.At(x + 1, y)),
                 Apart(plane, plane.At(x, y - 1), plane.At(x, y + 1))) +
        kLeast;
    if (root) contrast = std::sqrt(contrast);
    plane.contrast[i] = contrast;
    best = std::max(best, Gain(contrast, plane.distance2[i], plane.extent[i]));
  }
  return best;
}

/// The best gains of a row before it is compared.
const std::vector<float> kOld(Plane::kColumns, -1.0f);

TEST(SlotKernels, CompareNeighbors) {
  for (const bool root : {false, true}) {
    for (int row = 0; row < Plane::kRows; ++row) {
      Plane expected;
      std::ranges::fill(expected.changed, 1u << 13);
      std::vector<float> expected_best = kOld;
      for (int column = 0; column < Plane::kColumns; ++column) {
        expected_best[static_cast<std::size_t>(column)] =
            PlainCompare(column, row, root, expected);
      }
      ForEachSimdTarget([&] {
        Plane plane;
        std::ranges::fill(plane.changed, 1u << 13);
        std::vector<float> best = kOld;
        CompareSlots(plane.Slots(), row, kLeast, root, best.data());
        ExpectSame(plane, expected);
        EXPECT_EQ(best, expected_best);
      });
    }
  }
}

/// Which cells of row 1 are compared where one slot has changed.
std::vector<bool> ComparedAfter(int x, int y) {
  Plane plane;
  plane.changed[plane.Cell(x, y)] = 1u << Plane::InCell(x, y);
  std::vector<float> best = kOld;
  CompareSlots(plane.Slots(), 1, kLeast, false, best.data());
  std::vector<bool> compared;
  for (const float gain : best) compared.push_back(gain >= 0);
  return compared;
}

TEST(SlotKernels, CompareWhatChangedOrLiesBesideIt) {
  constexpr int kX = 2 * kSlotColumns;  // Of the third cell.
  constexpr int kY = kSlotRows;
  const std::vector<bool> alone = {false, false, true, false, false};
  const std::vector<bool> none(Plane::kColumns);
  EXPECT_EQ(ComparedAfter(kX + 1, kY + 3), alone);
  EXPECT_EQ(ComparedAfter(kX, kY + 3),
            (std::vector<bool>{false, true, true, false, false}));
  EXPECT_EQ(ComparedAfter(kX + 3, kY + 3),
            (std::vector<bool>{false, false, true, true, false}));
  EXPECT_EQ(ComparedAfter(kX + 1, kY - 1), alone);
  EXPECT_EQ(ComparedAfter(kX + 1, kY + kSlotRows), alone);
  EXPECT_EQ(ComparedAfter(kX + 1, kY - 2), none);
  EXPECT_EQ(ComparedAfter(kX + 1, kY + kSlotRows + 1), none);
}

// A slot that has a sample already is nearer to that one than to a second.
TEST(SlotKernels, ASampleThatChangesNoColorRenewsItsCellsBestGain) {
  Plane before;
  std::ranges::fill(before.distance2, 0.0f);
  const std::vector<SeenSample> samples = {
      {Plane::kColumns + 2, V2f(0.3f, 0.6f), Rgb(0), Rgb(0.5f)}};
  const std::vector<float> reaches = {4};
  ForEachSimdTarget([&] {
    Plane plane = before;
    EnterSamples(samples, reaches, 0, Plane::kRows - 1, plane.Slots());
    EXPECT_EQ(plane.r, before.r);
    EXPECT_NE(plane.extent, before.extent);
    std::vector<float> best = kOld;
    CompareSlots(plane.Slots(), 1, kLeast, false, best.data());
    EXPECT_EQ(best[2], PlainCompare(2, 1, false, plane));
    EXPECT_EQ(best[1], kOld[1]);
  });
}

}  // namespace
}  // namespace rtb
