#include "encoders/adaptive/voronoi_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/math/random.h"

namespace rtb {
namespace {

constexpr GridSize kGrid{7, 6};
constexpr double kCellAspect = 0.5;

float Random(int i, int dimension) {
  return UnitFloat(RandomBits(static_cast<std::uint32_t>(i), 0,
                              static_cast<std::uint32_t>(dimension), 23));
}

/// Random grays at places in every cell.
void Add(const std::vector<V2f>& positions, SeenSamples& samples) {
  SamplePlan plan;
  plan.grid = kGrid;
  plan.samples_per_cell = static_cast<int>(positions.size()) /
                          (positions.size() > 4 ? kGrid.cells() : 1);
  plan.positions = positions;
  Fragments fragments;
  for (std::size_t i = 0; i < plan.samples(); ++i) {
    fragments.values.emplace_back(
        Random(static_cast<int>(i + samples.all().size()), 2));
  }
  samples.Add(plan, fragments);
}

/// `each` samples in every cell, at random places.
std::vector<V2f> RandomPlaces(int each) {
  std::vector<V2f> places;
  for (int i = 0; i < kGrid.cells() * each; ++i) {
    places.emplace_back(Random(i, 0), Random(i, 1));
  }
  return places;
}

SeenSamples SamplesAt(const std::vector<V2f>& positions) {
  SeenSamples samples(kGrid);
  Add(positions, samples);
  return samples;
}

VoronoiMap MapOf(const SeenSamples& samples) {
  VoronoiMap map(kGrid, kCellAspect, Priority::kSquare);
  map.Clear();
  map.Insert(samples.all(), 1);
  return map;
}

/// In sixteenths of a cell's height, from the grid's top left.
V2f PlaceOf(int cell, const V2f& position) {
  const V2f corner(static_cast<float>(cell % kGrid.columns),
                   static_cast<float>(cell / kGrid.columns));
  return (corner + position) * V2f(8, 16);
}

/// Whether the square blocks of two places are the same or touch.
bool BlocksTouch(const V2f& a, const V2f& b) {
  const auto apart = [](float x, float y) {
    return std::abs(std::floor(x / kBlockHeight) -
                    std::floor(y / kBlockHeight));
  };
  return apart(a.x, b.x) <= 1 && apart(a.y, b.y) <= 1;
}

float Nearest(const SeenSamples& samples, const V2f& place, bool all) {
  float nearest = kFar2;
  for (const SeenSample& sample : samples.all()) {
    const V2f at = PlaceOf(sample.cell, sample.position);
    if (!all && !BlocksTouch(at, place)) continue;
    nearest = std::min(nearest, (at - place).length2());
  }
  return nearest;
}

void ExpectNearest(const VoronoiMap& map, const SeenSamples& samples,
                   bool all) {
  for (int cell = 0; cell < kGrid.cells(); ++cell) {
    for (int slot = 0; slot < kSlots; ++slot) {
      const float expected =
          Nearest(samples, PlaceOf(cell, SlotCenter(slot)), all);
      EXPECT_NEAR(map.Slots(cell).distance2[static_cast<std::size_t>(slot)],
                  expected, 1e-3f * expected + 1e-3f);
    }
  }
}

TEST(VoronoiMap, KnowsTheDistanceToTheNearestSampleOfTheBlocksAround) {
  const SeenSamples samples = SamplesAt(RandomPlaces(3));
  ExpectNearest(MapOf(samples), samples, false);
}

TEST(VoronoiMap, CountsTheSamplesOfASlot) {
  const SeenSamples samples = SamplesAt(RandomPlaces(40));
  const VoronoiMap map = MapOf(samples);
  for (int cell = 0; cell < kGrid.cells(); ++cell) {
    std::array<int, kSlots> counts{};
    for (const SeenSample& sample : samples.all()) {
      if (sample.cell == cell) ++counts[SlotAt(sample.position)];
    }
    for (std::size_t i = 0; i < kSlots; ++i) {
      EXPECT_EQ(map.Slots(cell).samples[i], counts[i]);
    }
  }
}

TEST(VoronoiMap, KnowsTheBestGainOfEachCell) {
  const VoronoiMap map = MapOf(SamplesAt(RandomPlaces(3)));
  for (int cell = 0; cell < kGrid.cells(); ++cell) {
    const CellSlots& slots = map.Slots(cell);
    float best = 0;
    for (std::size_t i = 0; i < kSlots; ++i) {
      best = std::max(best, Gain(slots.contrast[i], slots.distance2[i],
                                 ExtentOf(slots.samples[i])));
    }
    EXPECT_EQ(map.best_gains()[static_cast<std::size_t>(cell)], best) << cell;
  }
}

/// The slots of two maps are the same.
void ExpectSame(const VoronoiMap& a, const VoronoiMap& b) {
  for (int cell = 0; cell < kGrid.cells(); ++cell) {
    const CellSlots& one = a.Slots(cell);
    const CellSlots& other = b.Slots(cell);
    for (std::size_t i = 0; i < kSlots; ++i) {
      EXPECT_NEAR(one.distance2[i], other.distance2[i], 1e-4f) << cell;
    }
    EXPECT_EQ(one.color, other.color) << cell << "," << cell % kGrid.columns;
    EXPECT_EQ(one.samples, other.samples);
    EXPECT_EQ(one.contrast, other.contrast);
  }
}

const std::vector<V2f> kTwo = {V2f(0.25f, 0.24f), V2f(0.74f, 0.75f)};

// No sample is out of reach there, and no two are equally far.
TEST(VoronoiMap, StartsWithTheNearestSamples) {
  const std::vector<V2f> three = {V2f(0.9f, 0.11f), V2f(0.13f, 0.4f),
                                  V2f(0.57f, 0.82f)};
  for (const auto& positions : {{V2f(0.52f, 0.47f)}, kTwo, three}) {
    const SeenSamples samples = SamplesAt(positions);
    VoronoiMap map(kGrid, kCellAspect, Priority::kSquare);
    map.Start(samples.all(), positions, 1);
    ExpectNearest(map, samples, true);
    ExpectSame(map, MapOf(samples));
  }
}

// After Start most samples look at the blocks on the near sides alone.
TEST(VoronoiMap, EntersTheSameAfterEitherStart) {
  SeenSamples samples = SamplesAt(kTwo);
  VoronoiMap started(kGrid, kCellAspect, Priority::kSquare);
  started.Start(samples.all(), kTwo, 1);
  VoronoiMap inserted = MapOf(samples);
  Add(RandomPlaces(2), samples);
  const auto added =
      samples.all().last(2 * static_cast<std::size_t>(kGrid.cells()));
  for (const int threads : {1, 3}) {
    started.Insert(added, threads);
    inserted.Insert(added, threads);
  }
  ExpectSame(started, inserted);
  ExpectNearest(started, samples, true);
}

}  // namespace
}  // namespace rtb
