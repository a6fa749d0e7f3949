// The shorter way of choosing takes the same rays as the plain one.
#include "encoders/adaptive/choose_rays.h"

#include <gtest/gtest.h>

#include <set>
#include <utility>

#include "tests/encoders/plain_slots.h"

namespace rtb {
namespace {

/// More cells than a thread takes at once.
constexpr GridSize kGrid{40, 30};

float Unit(int i, std::uint32_t dimension) {
  return UnitFloat(RandomBits(static_cast<std::uint32_t>(i), dimension, 0, 21));
}

/// The samples of all cells at two places, by their cells.
template <class GrayOf>
SeenSamples SamplesOf(const GrayOf& gray_of) {
  SamplePlan plan;
  plan.grid = kGrid;
  plan.samples_per_cell = 2;
  plan.positions = {V2f(0.25f, 0.25f), V2f(0.75f, 0.75f)};
  Fragments fragments;
  for (int i = 0; i < 2 * kGrid.cells(); ++i) {
    fragments.values.emplace_back(gray_of(i / 2, i));
  }
  SeenSamples samples(kGrid);
  samples.Add(plan, fragments);
  return samples;
}

/// Nothing to see: cells gain the same.
SeenSamples Flat() {
  return SamplesOf([](int, int) { return 0.5f; });
}

/// Flat but for one cell in 15, which want many rays.
SeenSamples FewEdges() {
  return SamplesOf([](int cell, int i) {
    return cell % 15 == 7 && i % 2 == 0 ? Unit(cell, 1) : 0.5f;
  });
}

SeenSamples Noise() {
  return SamplesOf([](int, int i) { return Unit(i, 0); });
}

/// Noise in which every second cell has all that it may get.
SeenSamples HalfFull() {
  SamplePlan plan;
  plan.grid = kGrid;
  plan.samples_per_cell = kMostPerCell;
  plan.positions.assign(kMostPerCell, V2f(0.25f, 0.25f));
  for (int cell = 0; cell < kGrid.cells(); cell += 2) {
    plan.cells.push_back(cell);
  }
  Fragments fragments;
  for (std::size_t i = 0; i < plan.samples(); ++i) {
    fragments.values.emplace_back(Unit(static_cast<int>(i / kMostPerCell), 2));
  }
  SeenSamples samples(kGrid);
  samples.Add(plan, fragments);
  return samples;
}

/// Rays of a few counts, with `most` a cell, as the plain way chooses them.
void ExpectPlainRays(const SeenSamples& samples, int most) {
  VoronoiMap map(kGrid, 0.5, Priority::kSquare);
  map.Clear();
  map.Insert(samples.all(), 1);
  RayRequest request;
  request.seed = 5;
  request.most_per_cell = most;
  const int cells = kGrid.cells();
  for (const int rays : {1, 2, 17, 900, cells - 1, cells, cells + 1, 2 * cells,
                         2 * cells + 3, 3 * cells, 8 * cells, 99 * cells}) {
    request.rays = rays;
    const auto expected = PlainChooseRays(map, samples, request);
    for (const int threads : {1, 4}) {
      request.threads = threads;
      const auto chosen = RayChooser(map, samples).Choose(request);
      ASSERT_EQ(chosen.size(), expected.size()) << rays;
      for (std::size_t i = 0; i < chosen.size(); ++i) {
        EXPECT_EQ(chosen[i].cell, expected[i].cell) << rays << ", ray " << i;
        EXPECT_EQ(chosen[i].position, expected[i].position);
        EXPECT_EQ(chosen[i].gain, expected[i].gain);
      }
    }
  }
}

TEST(ChooseRays, IsThePlainWayInNoise) {
  for (const int most : {1, 2, 3, 12}) ExpectPlainRays(Noise(), most);
}

TEST(ChooseRays, IsThePlainWayAtFewEdges) {
  for (const int most : {1, 2, 12}) ExpectPlainRays(FewEdges(), most);
}

TEST(ChooseRays, IsThePlainWayAmongFullCells) {
  for (const int most : {1, 2, 12}) ExpectPlainRays(HalfFull(), most);
}

TEST(ChooseRays, IsThePlainWayAmongEqualGains) {
  for (const int most : {1, 2, 12}) ExpectPlainRays(Flat(), most);
}

// Cells take turns. A second visit would choose their first rays again.
TEST(ChooseRays, VisitsNoCellTwice) {
  for (const SeenSamples& samples : {Noise(), FewEdges(), Flat()}) {
    VoronoiMap map(kGrid, 0.5, Priority::kSquare);
    map.Clear();
    map.Insert(samples.all(), 1);
    for (const int rays : {100, 1000, 4000}) {
      RayRequest request;
      request.rays = rays;
      std::set<std::pair<int, std::pair<float, float>>> seen;
      int last = 0;
      for (const RayChoice& ray : RayChooser(map, samples).Choose(request)) {
        EXPECT_GE(ray.cell, last);
        last = ray.cell;
        EXPECT_TRUE(
            seen.insert({ray.cell, {ray.position.x, ray.position.y}}).second);
      }
      EXPECT_EQ(seen.size(), static_cast<std::size_t>(rays));
    }
  }
}

}  // namespace
}  // namespace rtb
