// Cells encoded on a GPU are those that the CPU's encoders choose.
#include <gtest/gtest.h>

#include <string>

#include "core/scene/load.h"
#include "encoders/cuda/device_encoder.h"
#include "encoders/registry.h"
#include "tests/encoders/given_source.h"
#include "tests/gpu/gpu_scenes.h"

namespace rtb {
namespace {

class GpuEncoderTest : public ::testing::TestWithParam<std::string> {};

TEST_P(GpuEncoderTest, GivesTheSameCells) {
  const Status runs = CudaRuns();
  if (!runs) GTEST_SKIP() << runs.error().ToString();
  const Scene scene = LoadScene(testing::CanonicalScene("whitted")).value();
  const auto cuda = MakeCudaBackend(scene).value();
  const auto device = DeviceEncoder::Make(GetParam()).value();
  const auto encoder = MakeEncoder(GetParam()).value();
  constexpr GridSize kGrid{97, 41};
  const SamplePlan plan = device->Plan(kGrid, 0.5);
  RenderOptions later;
  later.time = 0.4;
  // Two frames under way, of one plan.
  ASSERT_TRUE(device->Submit(*cuda, plan, {}, 0).has_value());
  ASSERT_TRUE(device->Submit(*cuda, plan, later, 0).has_value());
  const CellGrid first = device->Collect(*cuda).value();
  const CellGrid second = device->Collect(*cuda).value();
  GivenSource source(cuda->Render(plan, {})->values);
  EXPECT_EQ(first, encoder->Run(source, kGrid, 0.5, {})->grid);
  GivenSource moved(cuda->Render(plan, later)->values);
  EXPECT_EQ(second, encoder->Run(moved, kGrid, 0.5, {})->grid);
}

INSTANTIATE_TEST_SUITE_P(Encoders, GpuEncoderTest,
                         ::testing::Values("half", "quadrant", "sextant",
                                           "octant", "tiv"),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace rtb
