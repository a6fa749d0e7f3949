#include "core/shading/texture_load.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/color/srgb.h"
#include "tests/core/image/image_files.h"
#include "tests/temp_folder.h"

namespace rtb {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

OIIO::ImageSpec Gray(OIIO::TypeDesc type) { return {2, 1, 1, type}; }

TEST(LoadTextureTest, IntegersAreDecodedFloatsAreLinear) {
  const TempFolder folder;
  const float values[] = {100 / 255.0f, 200 / 255.0f};
  const std::vector<float> pixels(values, values + 2);
  Write(folder / "8.png", Gray(OIIO::TypeDesc::UINT8), pixels);
  Write(folder / "16.png", Gray(OIIO::TypeDesc::UINT16), pixels);
  Write(folder / "float.exr", Named(2, 1, {"Y"}), pixels);
  for (const char* name : {"8.png", "16.png"}) {
    const auto image = LoadTexture(folder / name);
    ASSERT_TRUE(image) << image.error().ToString();
    EXPECT_NEAR(image->at(0, 0).x, SrgbDecode8(100), 1e-6) << name;
    EXPECT_NEAR(image->at(1, 0).z, SrgbDecode8(200), 1e-6) << name;
  }
  EXPECT_EQ(LoadTexture(folder / "float.exr").value().at(1, 0),
            Rgb(200 / 255.0f));
}

// Codes over the largest code: 8 bits in 255ths, 16 in 65535ths; no decoding.
TEST(LoadHeightMapTest, CodesAreLinear) {
  const TempFolder folder;
  Write(folder / "8.png", Gray(OIIO::TypeDesc::UINT8),
        {100 / 255.0f, 200 / 255.0f});
  const auto bytes = LoadHeightMap(folder / "8.png");
  ASSERT_TRUE(bytes) << bytes.error().ToString();
  EXPECT_EQ(bytes->width, 2);
  EXPECT_EQ(bytes->height, 1);
  EXPECT_FLOAT_EQ(bytes->values[0], 100 / 255.0f);
  EXPECT_FLOAT_EQ(bytes->values[1], 200 / 255.0f);
  Write(folder / "16.png", Gray(OIIO::TypeDesc::UINT16),
        {1000 / 65535.0f, 40001 / 65535.0f});
  const auto words = LoadHeightMap(folder / "16.png");
  ASSERT_TRUE(words) << words.error().ToString();
  EXPECT_FLOAT_EQ(words->values[0], 1000 / 65535.0f);
  EXPECT_FLOAT_EQ(words->values[1], 40001 / 65535.0f);
}

TEST(LoadHeightMapTest, FloatsAreAsTheyAreAndColorsGiveTheirMean) {
  const TempFolder folder;
  Write(folder / "a.exr", Named(2, 1, {"R", "G", "B"}),
        {0.1f, 0.1f, 0.1f, -3, 1, 8});
  const auto map = LoadHeightMap(folder / "a.exr");
  ASSERT_TRUE(map) << map.error().ToString();
  EXPECT_EQ(map->values, (std::vector<float>{0.1f, 2}));
}

/// Expects an Error of bad input that blames the file and says `text`.
template <class T>
void ExpectError(const Result<T>& result, const std::filesystem::path& file,
                 const std::string& text) {
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().kind, ErrorKind::kBadInput);
  EXPECT_EQ(result.error().place, file.string());
  EXPECT_NE(result.error().what.find(text), std::string::npos)
      << result.error().what;
}

TEST(LoadTextureTest, ErrorsNameTheFileAndThePixel) {
  const TempFolder folder;
  const auto file = folder / "a.exr";
  ExpectError(LoadTexture(file), file, "cannot be read");
  Write(file, Named(2, 1, {"Y"}), {0.5f, 1.5f});
  ExpectError(LoadTexture(file), file, "column 1, row 0");
  Write(file, Named(2, 1, {"Y"}), {-0.5f, 1});
  ExpectError(LoadTexture(file), file, "an albedo of (-0.5 -0.5 -0.5)");
  Write(file, Named(2, 1, {"Y"}), {kNan, 1});
  ExpectError(LoadTexture(file), file, "expected finite numbers >= 0 and <= 1");
  ExpectError(LoadHeightMap(file), file, "expected finite numbers");
  ExpectError(LoadHeightMap(folder / "b.exr"), folder / "b.exr",
              "cannot be read");
}

}  // namespace
}  // namespace rtb
