#include "harness/sweep/identity.h"

#include <gtest/gtest.h>

#include <functional>

#include "harness/sweep/expand.h"
#include "tests/harness/sweep/suites.h"

namespace rtb {
namespace {

constexpr char kSuite[] =
    "scenes: [sky]\nencoders: [half]\ngrids: [12x4]\nkinds: [quality]\n"
    "references: [self]\n";

/// The hashes of a suite's units.
std::vector<std::string> Hashes(const SuiteFolder& suites,
                                const std::string& rest = kSuite) {
  std::vector<SweepUnit> units = Expand(suites.Parse(rest).value());
  Identify(units);
  std::vector<std::string> hashes;
  for (const SweepUnit& unit : units) hashes.push_back(unit.hash);
  return hashes;
}

TEST(IdentityTest, IsTheSameInAnotherFolder) {
  const SuiteFolder one;
  const SuiteFolder other;
  const auto hashes = Hashes(one);
  ASSERT_EQ(hashes.size(), 1u);
  EXPECT_EQ(hashes[0].size(), 16u);
  EXPECT_EQ(hashes, Hashes(other));
}

TEST(IdentityTest, ChangesWithTheContentOfTheScene) {
  SuiteFolder suites;
  const auto before = Hashes(suites);
  suites.folder().Write("data/scenes/sky.yaml",
                        SuiteFolder::SceneText("sky") + "# changed\n");
  EXPECT_NE(Hashes(suites), before);
}

TEST(IdentityTest, ChangesWithTheContentOfAMesh) {
  SuiteFolder suites;
  const std::string mesh = "v 0 0 -5\nv 1 0 -5\nv 0 1 -5\nf 1 2 3\n";
  suites.folder().Write("data/scenes/a.obj", mesh);
  suites.folder().Write(
      "data/scenes/sky.yaml",
      SuiteFolder::SceneText("sky") + "objects: [{type: mesh, file: a.obj}]\n");
  const auto before = Hashes(suites);
  suites.folder().Write("data/scenes/a.obj", mesh + "# changed\n");
  EXPECT_NE(Hashes(suites), before);
}

TEST(IdentityTest, ChangesWithTheContentOfTheReference) {
  SuiteFolder suites;
  suites.folder().Write("r.png", "one");
  const std::string suite =
      "scenes: [sky]\nencoders: [half]\nkinds: [quality]\n"
      "references: [r.png]\n";
  const auto before = Hashes(suites, suite);
  EXPECT_EQ(Hashes(suites, suite), before);
  suites.folder().Write("r.png", "two");
  EXPECT_NE(Hashes(suites, suite), before);
}

TEST(IdentityTest, ChangesWithTheProgramThatIsRun) {
  SuiteFolder suites;
  const auto program = suites.folder().Write("draw", "#!/bin/sh\n");
  const std::string suite =
      "scenes: [sky]\nkinds: [quality]\nencoders: ['external:" +
      program.string() + " {input}']\n";
  // Not a program yet, then one.
  const auto missing = Hashes(suites, suite);
  std::filesystem::permissions(program, std::filesystem::perms::owner_all);
  EXPECT_NE(Hashes(suites, suite), missing);
}

TEST(IdentityTest, ChangesWithEveryPartOfTheUnit) {
  SweepUnit unit;
  unit.configuration = {"sky",     0,           {12, 4}, 1, "embree",
                        "whitted", "truecolor", "",      0, {"half"}};
  unit.repeat = 3;
  const std::vector<std::function<void(SweepUnit&)>> changes = {
      [](SweepUnit& u) { u.kind = UnitKind::kTiming; },
      [](SweepUnit& u) { u.configuration.scene = "sun"; },
      [](SweepUnit& u) { u.configuration.time = 1; },
      [](SweepUnit& u) {
        u.configuration.grid = {24, 8};
      },
      [](SweepUnit& u) { u.configuration.spp = 2; },
      [](SweepUnit& u) { u.configuration.backend = "bvh"; },
      [](SweepUnit& u) { u.configuration.integrator = "path"; },
      [](SweepUnit& u) { u.configuration.color = "256"; },
      [](SweepUnit& u) { u.configuration.reference = "self"; },
      [](SweepUnit& u) { u.configuration.seed = 1; },
      [](SweepUnit& u) { u.configuration.encoders = {"tiv"}; },
      [](SweepUnit& u) { u.repeat = 4; },
      [](SweepUnit& u) { u.frames = 2; },
      [](SweepUnit& u) { u.fps = 25; },
      [](SweepUnit& u) { u.pictures = true; }};
  std::vector<SweepUnit> units(changes.size() + 1, unit);
  for (std::size_t i = 0; i < changes.size(); ++i) changes[i](units[i + 1]);
  Identify(units);
  for (std::size_t i = 0; i < units.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      EXPECT_NE(units[i].hash, units[k].hash) << i << " and " << k;
    }
  }
}

}  // namespace
}  // namespace rtb
