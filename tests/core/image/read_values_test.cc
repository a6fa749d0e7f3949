#include <gtest/gtest.h>

#include <cstdint>

#include "tests/core/image/image_files.h"
#include "tests/temp_folder.h"

namespace rtb {
namespace {

TEST(ReadValues, IntegersAreCodesOverTheLargest) {
  const auto image = ReadValues(Data("gray8.png"));
  ASSERT_TRUE(image) << image.error().ToString();
  ASSERT_EQ(image->width(), 256);
  for (int i = 0; i < 256; ++i) {
    EXPECT_FLOAT_EQ(image->at(i, 0).y, static_cast<float>(i) / 255);
  }
  const auto words = ReadValues(Data("rgb16.png"));
  ASSERT_TRUE(words) << words.error().ToString();
  EXPECT_FLOAT_EQ(words->at(0, 0).x, 1000 / 65535.0f);
  EXPECT_FLOAT_EQ(words->at(0, 0).y, 1001 / 65535.0f);
}

TEST(ReadValues, FloatsAreUnchanged) {
  const TempFolder folder;
  Write(folder / "a.exr", Named(1, 1, {"R", "G", "B"}), {0.5f, 2, -1});
  EXPECT_EQ(ReadValues(folder / "a.exr").value().at(0, 0), Rgb(0.5f, 2, -1));
}

TEST(ReadValues, ErrorsNameTheFile) {
  ExpectBadInput(ReadValues(Data("none.png")), Data("none.png").string());
}

}  // namespace
}  // namespace rtb
