#include "encoders/adaptive/voronoi_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/math/random.h"

namespace rtb {
namespace {

/// More rows than a thread takes at once, and grids that are all border.
constexpr GridSize kGrids[] = {{7, 19}, {3, 5}, {1, 4}, {5, 1}, {1, 1}};

const std::vector<V2f> kOne = {V2f(0.52f, 0.47f)};
const std::vector<V2f> kTwo = {V2f(0.25f, 0.24f), V2f(0.74f, 0.75f)};
const std::vector<V2f> kThree = {V2f(0.9f, 0.11f), V2f(0.13f, 0.4f),
                                 V2f(0.57f, 0.82f)};

float Random(std::size_t i, std::uint32_t dimension) {
  return UnitFloat(RandomBits(static_cast<std::uint32_t>(i), 0, dimension, 23));
}

/// A grid of cells that are `width` wide, 16 high, and samples in random grays.
struct World {
  explicit World(GridSize its_grid, float its_width = 8)
      : grid(its_grid), width(its_width), samples(its_grid) {}

  /// @param places in every cell the same, or cell by cell.
  void Add(const std::vector<V2f>& places, std::size_t each) {
    SamplePlan plan;
    plan.grid = grid;
    plan.samples_per_cell = static_cast<int>(each);
    plan.positions = places;
    Fragments fragments;
    for (std::size_t i = 0; i < plan.samples(); ++i) {
      fragments.values.emplace_back(Random(i + samples.all().size(), 2));
    }
    samples.Add(plan, fragments);
  }
  void AddRandom(std::size_t each) {
    std::vector<V2f> places;
    for (std::size_t i = 0; i < each * cells(); ++i) {
      places.emplace_back(Random(i, 0), Random(i, 1));
    }
    Add(places, each);
  }

  VoronoiMap Map() const {
    return {grid, static_cast<double>(width) / kCellHeight, Priority::kRoot};
  }
  VoronoiMap Started(const std::vector<V2f>& places) const {
    VoronoiMap map = Map();
    map.Start(samples.all().first(places.size() * cells()), places, 1);
    return map;
  }
  VoronoiMap Inserted() const {
    VoronoiMap map = Map();
    map.Clear();
    map.Insert(samples.all(), 1);
    return map;
  }

  std::size_t cells() const { return static_cast<std::size_t>(grid.cells()); }
  /// From the grid's top left.
  V2f PlaceOf(int cell, const V2f& position) const {
    const V2f corner(static_cast<float>(cell % grid.columns),
                     static_cast<float>(cell / grid.columns));
    return (corner + position) * V2f(width, kCellHeight);
  }
  /// Whether the blocks of two places are the same or touch.
  bool BlocksTouch(const V2f& a, const V2f& b) const {
    const auto apart = [](float x, float y, float size) {
      return std::abs(std::floor(x / size) - std::floor(y / size));
    };
    return apart(a.x, b.x, width) <= 1 && apart(a.y, b.y, kBlockHeight) <= 1;
  }
  /// The squared distance of the nearest sample: of all or of those in the
  /// blocks around.
  float Nearest(const V2f& place, bool all) const {
    float nearest = kFar2;
    for (const SeenSample& sample : samples.all()) {
      const V2f at = PlaceOf(sample.cell, sample.position);
      if (!all && !BlocksTouch(at, place)) continue;
      nearest = std::min(nearest, (at - place).length2());
    }
    return nearest;
  }

  GridSize grid;
  float width;
  SeenSamples samples;
};

void ExpectNearest(const World& world, const VoronoiMap& map, bool all) {
  for (int cell = 0; cell < world.grid.cells(); ++cell) {
    for (int slot = 0; slot < kSlots; ++slot) {
      const float expected =
          world.Nearest(world.PlaceOf(cell, SlotCenter(slot)), all);
      EXPECT_NEAR(map.Slots(cell).distance2[static_cast<std::size_t>(slot)],
                  expected, 1e-3f * expected + 1e-3f);
    }
  }
}

TEST(VoronoiMap, KnowsTheDistanceToTheNearestSampleOfTheBlocksAround) {
  for (const GridSize grid : kGrids) {
    for (const float width : {4.0f, 8.0f, 16.0f}) {
      World world(grid, width);
      world.AddRandom(3);
      ExpectNearest(world, world.Inserted(), false);
    }
  }
}

TEST(VoronoiMap, CountsTheSamplesOfASlot) {
  World world(kGrids[0]);
  world.AddRandom(40);
  const VoronoiMap map = world.Inserted();
  for (int cell = 0; cell < world.grid.cells(); ++cell) {
    std::array<int, kSlots> counts{};
    for (const SeenSample& sample : world.samples.all()) {
      if (sample.cell == cell) ++counts[SlotAt(sample.position)];
    }
    for (std::size_t i = 0; i < kSlots; ++i) {
      EXPECT_EQ(map.Slots(cell).samples[i], counts[i]);
    }
  }
}

TEST(VoronoiMap, KnowsTheBestGainOfEachCell) {
  World world(kGrids[0]);
  world.AddRandom(3);
  const VoronoiMap map = world.Inserted();
  for (int cell = 0; cell < world.grid.cells(); ++cell) {
    const CellSlots& slots = map.Slots(cell);
    float best = 0;
    for (std::size_t i = 0; i < kSlots; ++i) {
      best = std::max(best, Gain(slots.contrast[i], slots.distance2[i],
                                 ExtentOf(slots.samples[i])));
    }
    EXPECT_EQ(map.best_gains()[static_cast<std::size_t>(cell)], best) << cell;
  }
}

/// The red of a slot, counted over the whole grid; its border is repeated.
float Red(const World& world, const VoronoiMap& map, int x, int y) {
  x = std::clamp(x, 0, world.grid.columns * kSlotColumns - 1);
  y = std::clamp(y, 0, world.grid.rows * kSlotRows - 1);
  const int cell = y / kSlotRows * world.grid.columns + x / kSlotColumns;
  const int slot = y % kSlotRows * kSlotColumns + x % kSlotColumns;
  const std::uint32_t color =
      map.Slots(cell).color[static_cast<std::size_t>(slot)];
  return static_cast<float>(color >> (2 * kChannelBits)) / kChannelMost;
}

TEST(VoronoiMap, ComparesNeighborsAcrossCellsAndAtTheBorder) {
  for (const GridSize grid : kGrids) {
    World world(grid);
    world.Add(kTwo, 2);
    const VoronoiMap map = world.Started(kTwo);
    for (int y = 0; y < grid.rows * kSlotRows; ++y) {
      for (int x = 0; x < grid.columns * kSlotColumns; ++x) {
        const float beside =
            Red(world, map, x - 1, y) - Red(world, map, x + 1, y);
        const float above =
            Red(world, map, x, y - 1) - Red(world, map, x, y + 1);
        const int cell = y / kSlotRows * grid.columns + x / kSlotColumns;
        const int slot = y % kSlotRows * kSlotColumns + x % kSlotColumns;
        EXPECT_NEAR(map.Slots(cell).contrast[static_cast<std::size_t>(slot)],
                    3 * std::max(beside * beside, above * above), 3e-6f)
            << grid.columns << " x " << grid.rows << ": " << x << ", " << y;
      }
    }
  }
}

/// The slots of two maps are the same.
void ExpectSame(const World& world, const VoronoiMap& a, const VoronoiMap& b) {
  for (int cell = 0; cell < world.grid.cells(); ++cell) {
    const CellSlots& one = a.Slots(cell);
    const CellSlots& other = b.Slots(cell);
    for (std::size_t i = 0; i < kSlots; ++i) {
      EXPECT_NEAR(one.distance2[i], other.distance2[i], 1e-4f) << cell;
    }
    EXPECT_EQ(one.color, other.color) << cell;
    EXPECT_EQ(one.samples, other.samples) << cell;
    EXPECT_EQ(one.contrast, other.contrast) << cell;
  }
}

// No sample is out of reach there, and no two are equally far.
TEST(VoronoiMap, StartsWithTheNearestSamples) {
  for (const GridSize grid : kGrids) {
    for (const auto& places : {kOne, kTwo, kThree}) {
      World world(grid);
      world.Add(places, places.size());
      const VoronoiMap map = world.Started(places);
      ExpectNearest(world, map, true);
      ExpectSame(world, map, world.Inserted());
    }
  }
}

// After Start most samples look at the blocks on the near sides alone.
TEST(VoronoiMap, EntersTheSameAfterEitherStartOnAnyThreads) {
  for (const GridSize grid : kGrids) {
    World world(grid);
    world.Add(kTwo, 2);
    VoronoiMap inserted = world.Inserted();
    world.AddRandom(2);
    const auto added = world.samples.all().last(2 * world.cells());
    inserted.Insert(added, 1);
    ExpectNearest(world, inserted, true);
    for (const int threads : {1, 3}) {
      VoronoiMap started = world.Started(kTwo);
      started.Insert(added, threads);
      ExpectSame(world, started, inserted);
    }
  }
}

}  // namespace
}  // namespace rtb
