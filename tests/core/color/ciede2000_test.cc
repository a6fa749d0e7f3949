#include "core/color/ciede2000.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace rtb {
namespace {

struct Pair {
  V3d first = V3d(0);
  V3d second = V3d(0);
  double difference = 0;
};

/// The test data of Sharma, Wu and Dalal 2005. A line holds pair, 1, L, a, b,
/// nine intermediate and four weighting values, the difference, 2, L, a, b...
std::vector<Pair> SharmaPairs() {
  std::ifstream in(std::string(RTB_TEST_SOURCE_DIR) +
                   "/tests/data/metrics/sharma_ciede2000_34pairs.txt");
  std::vector<Pair> pairs;
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::istringstream fields(line);
    std::vector<double> v;
    for (double value = 0; fields >> value;) v.push_back(value);
    pairs.push_back({V3d(v.at(2), v.at(3), v.at(4)),
                     V3d(v.at(17), v.at(18), v.at(19)), v.at(15)});
  }
  return pairs;
}

TEST(Ciede2000Test, AgreesWithSharmasPairs) {
  const std::vector<Pair> pairs = SharmaPairs();
  ASSERT_EQ(pairs.size(), 34u);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const Pair& pair = pairs[i];
    EXPECT_NEAR(Ciede2000(pair.first, pair.second), pair.difference, 1e-4)
        << "pair " << i + 1;
    EXPECT_NEAR(Ciede2000(pair.second, pair.first), pair.difference, 1e-4)
        << "pair " << i + 1 << " swapped";
  }
}

TEST(Ciede2000Test, OfEqualColorsIsZero) {
  EXPECT_EQ(Ciede2000({50, 20, -30}, {50, 20, -30}), 0);
  EXPECT_EQ(Ciede2000({0, 0, 0}, {0, 0, 0}), 0);
}

// Grays differ by dL' / SL alone; around L = 50, SL = 1.
TEST(Ciede2000Test, OfGraysAroundTheMiddleIsTheLightnessDifference) {
  EXPECT_DOUBLE_EQ(Ciede2000({49, 0, 0}, {51, 0, 0}), 2);
}

}  // namespace
}  // namespace rtb
