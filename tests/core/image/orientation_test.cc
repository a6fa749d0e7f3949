#include "core/image/orientation.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace rtb {
namespace {

using Rows = std::vector<std::string>;

Image FromText(const Rows& rows) {
  Image image(static_cast<int>(rows[0].size()), static_cast<int>(rows.size()));
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      image.at(x, y) = Rgb(static_cast<float>(
          rows[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)]));
    }
  }
  return image;
}

Rows ToText(const Image& image) {
  Rows rows;
  for (int y = 0; y < image.height(); ++y) {
    rows.emplace_back();
    for (int x = 0; x < image.width(); ++x) {
      rows.back() += static_cast<char>(image.at(x, y).x);
    }
  }
  return rows;
}

// The stored images of EXIF's own eight cases, all of the same upright "F".
TEST(Upright, TurnsAllEightToTheSame) {
  const Rows upright = {"XXX", "X..", "XX.", "X..", "X.."};
  const std::vector<Rows> stored = {
      {"XXX", "X..", "XX.", "X..", "X.."},  // 1: as it is
      {"XXX", "..X", ".XX", "..X", "..X"},  // 2: mirrored
      {"..X", "..X", ".XX", "..X", "XXX"},  // 3: upside down
      {"X..", "X..", "XX.", "X..", "XXX"},  // 4: mirrored upside down
      {"XXXXX", "X.X..", "X...."},          // 5: rows are columns
      {"X....", "X.X..", "XXXXX"},          // 6: turn clockwise to see it
      {"....X", "..X.X", "XXXXX"},          // 7: 5 from the other corner
      {"XXXXX", "..X.X", "....X"},          // 8: turn counterclockwise
  };
  for (std::size_t i = 0; i < stored.size(); ++i) {
    const int orientation = static_cast<int>(i) + 1;
    EXPECT_EQ(ToText(Upright(FromText(stored[i]), orientation)), upright)
        << orientation;
  }
}

TEST(Upright, UnknownValuesChangeNothing) {
  for (const int orientation : {-1, 0, 9, 1000}) {
    EXPECT_EQ(ToText(Upright(FromText({"ab", "cd"}), orientation)),
              (Rows{"ab", "cd"}));
  }
}

}  // namespace
}  // namespace rtb
