#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <sstream>
#include <string>

#include "core/image/io.h"

namespace rtb {
namespace {

TEST(EncodePpm, WritesTheFormat) {
  Image image(2, 2);
  image.at(0, 0) = Rgb(1, 0, 0.5f);  // 0.5 * 255 = 127.5, rounded up
  image.at(1, 0) = Rgb(2, -1, std::numeric_limits<float>::quiet_NaN());
  image.at(1, 1) = Rgb(10.0f / 255);
  EXPECT_EQ(EncodePpm(image),
            "P3\n2 2\n255\n"
            "255 0 128 255 0 0\n"
            "0 0 0 10 10 10\n");
}

TEST(EncodePpm, LinesHave70CharactersAtMost) {
  Image image(101, 3);
  std::ranges::fill(image.pixels(), Rgb(1));
  std::istringstream lines(EncodePpm(image));
  std::size_t longest = 0;
  for (std::string line; std::getline(lines, line);) {
    longest = std::max(longest, line.size());
    EXPECT_NE(line.back(), ' ');
  }
  // 17 words of three characters and the blanks between them: 67; one more
  // would be 71.
  EXPECT_EQ(longest, 67u);
  std::istringstream words(EncodePpm(image));
  std::string word;
  int count = 0;
  while (words >> word) ++count;
  EXPECT_EQ(count, 4 + 101 * 3 * 3);
}

TEST(EncodePpm, NoPixels) { EXPECT_EQ(EncodePpm(Image()), "P3\n0 0\n255\n"); }

}  // namespace
}  // namespace rtb
