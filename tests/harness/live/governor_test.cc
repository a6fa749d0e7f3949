#include "harness/live/governor.h"

#include <gtest/gtest.h>

namespace rtb {
namespace {

/// What a picture takes, in milliseconds, with a budget.
struct Machine {
  double full_ms;   ///< Tracing with all rays.
  double fixed_ms;  ///< Encoding, for all rows.
  int spp = 1;

  double Render(const RayBudget& budget) const {
    return full_ms * budget.share * budget.spp / spp / budget.row_step;
  }
  double Encode(const RayBudget& budget) const {
    return fixed_ms / budget.row_step;
  }
  double Time(const RayBudget& budget) const {
    return Render(budget) + Encode(budget);
  }
};

/// The budget that a governor has settled on.
RayBudget Settled(Governor* governor, const Machine& machine,
                  double samples = 4) {
  for (int frame = 0; frame < 400; ++frame) {
    governor->Describe(machine.spp, samples);
    const RayBudget budget = governor->budget();
    governor->Note(machine.Render(budget), machine.Encode(budget));
  }
  return governor->budget();
}

TEST(Governor, LeavesAFastMachineAlone) {
  Governor governor(60);
  EXPECT_EQ(Settled(&governor, {5, 1}), RayBudget{});
}

TEST(Governor, DropsRaysUntilTheRateHolds) {
  Governor governor(60);
  const Machine machine{40, 1};
  const RayBudget budget = Settled(&governor, machine);
  EXPECT_LT(machine.Time(budget), 1e3 / 60);
  // And no more than that takes: more than half of the time is used.
  EXPECT_GT(machine.Time(budget), 0.5 * 1e3 / 60);
  EXPECT_EQ(budget.row_step, 1);
  EXPECT_EQ(budget.spp, 1);
}

TEST(Governor, RaysPerSampleGoBeforeSamples) {
  Governor governor(60);
  const Machine machine{60, 0.5, 16};
  const RayBudget budget = Settled(&governor, machine);
  EXPECT_EQ(budget.share, 1);
  EXPECT_GT(budget.spp, 1);
  EXPECT_LT(budget.spp, 16);
  EXPECT_LT(machine.Time(budget), 1e3 / 60);
}

TEST(Governor, RowsTakeTurnsWhenEncodingAloneIsTooSlow) {
  Governor governor(60);
  const Machine machine{10, 45};
  const RayBudget budget = Settled(&governor, machine);
  EXPECT_EQ(budget.row_step, 4);
  EXPECT_LT(machine.Time(budget), 1e3 / 60);
  EXPECT_EQ(budget.share, 1);  // Fewer rays would not help.
}

TEST(Governor, ComesBackWhenTheMachineIsFree) {
  Governor governor(60);
  Settled(&governor, {200, 20});
  EXPECT_NE(governor.budget(), RayBudget{});
  EXPECT_EQ(Settled(&governor, {5, 1}), RayBudget{});
}

TEST(Governor, OneSlowFrameIsAnAccident) {
  Governor governor(60);
  Settled(&governor, {9, 1});
  governor.Note(15, 1);
  governor.Note(9, 1);
  EXPECT_EQ(governor.budget(), RayBudget{});
}

TEST(Governor, OffMeansAllRays) {
  Governor governor(0);
  const RayBudget budget = Settled(&governor, {500, 500, 8});
  EXPECT_EQ(budget, (RayBudget{8, 1, 1}));
}

TEST(Governor, TracesAtLeastOneRayForFourCells) {
  Governor governor(60);
  const RayBudget budget = Settled(&governor, {1e6, 1}, 32);
  EXPECT_NEAR(budget.share * 32, 0.25, 1e-9);
  EXPECT_EQ(budget.row_step, 8);
}

}  // namespace
}  // namespace rtb
