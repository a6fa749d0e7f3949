#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <thread>

#include "core/base/file.h"
#include "core/color/srgb.h"
#include "core/image/io.h"
#include "tests/temp_folder.h"

namespace rtb {
namespace {

constexpr float kInf = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// Values of many magnitudes, below 0 and above 1 among them.
Image Lights(int width, int height) {
  Image image(width, height);
  float value = -3;
  for (Rgb& color : image.pixels()) {
    color = Rgb(value, value * value, 1 / (value * 3 + 0.1f));
    value += 0.37f;
  }
  return image;
}

/// All 256 codes, as encoded values.
Image Codes() {
  Image image(16, 16);
  for (int i = 0; i < 256; ++i) {
    const auto code = static_cast<std::uint8_t>(i);
    const auto other = static_cast<std::uint8_t>(255 - i);
    image.at(i % 16, i / 16) = EncodedValues(Rgb8{code, other, 7});
  }
  return image;
}

TEST(WriteExr, FloatIsLossless) {
  const TempFolder folder;
  const Image image = Lights(33, 21);
  ASSERT_TRUE(WriteExr(folder / "a.exr", image, ExrType::kFloat));
  const auto read = ReadLinear(folder / "a.exr");
  ASSERT_TRUE(read) << read.error().ToString();
  EXPECT_EQ(read->width(), 33);
  EXPECT_TRUE(std::ranges::equal(read->pixels(), image.pixels()));
}

// A half has 11 significant bits: half a unit in the last place is 2^-12 of
// the value, rounded up here.
TEST(WriteExr, HalfRoundsTo11Bits) {
  const TempFolder folder;
  const Image image = Lights(9, 5);
  ASSERT_TRUE(WriteExr(folder / "a.exr", image, ExrType::kHalf));
  const auto read = ReadLinear(folder / "a.exr");
  ASSERT_TRUE(read) << read.error().ToString();
  for (std::size_t i = 0; i < image.pixels().size(); ++i) {
    const Rgb expected = image.pixels()[i];
    EXPECT_NEAR(read->pixels()[i].x, expected.x,
                std::abs(expected.x) * 0x1p-11f);
    EXPECT_NEAR(read->pixels()[i].y, expected.y,
                std::abs(expected.y) * 0x1p-11f);
  }
}

TEST(WriteExr, KeepsWhatIsNotFinite) {
  const TempFolder folder;
  Image image(1, 1);
  image.at(0, 0) = Rgb(kNan, kInf, -kInf);
  for (const ExrType type : {ExrType::kHalf, ExrType::kFloat}) {
    ASSERT_TRUE(WriteExr(folder / "a.exr", image, type));
    const Rgb read = ReadLinear(folder / "a.exr").value().at(0, 0);
    EXPECT_TRUE(std::isnan(read.x));
    EXPECT_EQ(read.y, kInf);
    EXPECT_EQ(read.z, -kInf);
  }
}

// A second apart, so that a date in a file would show.
TEST(Write, SameImageSameBytes) {
  const TempFolder folder;
  const Image image = Lights(64, 48);
  std::string hashes[2];
  for (std::string& hash : hashes) {
    ASSERT_TRUE(WriteExr(folder / "a.exr", image, ExrType::kHalf));
    ASSERT_TRUE(WritePng(folder / "a.png", image));
    hash = Sha256File(folder / "a.exr").value() +
           Sha256File(folder / "a.png").value();
    if (hashes[1].empty()) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1100));
    }
  }
  EXPECT_EQ(hashes[0], hashes[1]);
}

TEST(WritePng, KeepsEveryCode) {
  const TempFolder folder;
  const Image codes = Codes();
  ASSERT_TRUE(WritePng(folder / "a.png", codes));
  const auto read = ReadLinear(folder / "a.png");
  ASSERT_TRUE(read) << read.error().ToString();
  for (std::size_t i = 0; i < 256; ++i) {
    EXPECT_EQ(read->pixels()[i], Decode8(QuantizeEncoded(codes.pixels()[i])));
    EXPECT_EQ(Encode8(read->pixels()[i]), QuantizeEncoded(codes.pixels()[i]));
  }
}

TEST(Write, FailuresAreErrors) {
  const TempFolder folder;
  for (const std::string name : {"a.png", "a.exr", "a.ppm"}) {
    const auto status =
        WriteRender(folder.path() / name / "below.png", Image(1, 1), 0);
    EXPECT_TRUE(status);
    // A folder stands where the file should go.
    const auto over = WriteRender(folder / name, Image(1, 1), 0);
    ASSERT_FALSE(over);
    EXPECT_EQ(over.error().place, (folder / name).string());
  }
  EXPECT_FALSE(WritePng(folder / "none.png", Image()));
  EXPECT_FALSE(WriteExr(folder / "none.exr", Image(), ExrType::kHalf));
}

TEST(WriteRender, ChoosesByExtension) {
  const TempFolder folder;
  Image image(1, 1);
  image.at(0, 0) = Rgb(0.25f, 2, 0);
  for (const std::string name : {"a.ppm", "a.PNG", "a.exr"}) {
    ASSERT_TRUE(WriteRender(folder / name, image, 1)) << name;
  }
  // One stop brighter: 0.5, 4 (clipped) and 0. 0.5 is encoded as
  // 1.055 * 0.5^(1/2.4) - 0.055 = 0.735357, times 255: 187.5, so 188.
  EXPECT_EQ(ReadFile(folder / "a.ppm").value(), "P3\n1 1\n255\n188 255 0\n");
  EXPECT_EQ(Encode8(ReadLinear(folder / "a.PNG").value().at(0, 0)),
            (Rgb8{188, 255, 0}));
  // Linear, neither exposed nor clipped.
  EXPECT_EQ(ReadLinear(folder / "a.exr").value().at(0, 0), image.at(0, 0));
}

TEST(WriteRender, OtherExtensionsAreErrorsThatListTheseThree) {
  const TempFolder folder;
  for (const std::string name : {"a.jpg", "a", "png"}) {
    const auto status = WriteRender(folder / name, Image(1, 1), 0);
    ASSERT_FALSE(status);
    EXPECT_EQ(status.error().kind, ErrorKind::kBadInput);
    for (const char* format : {".ppm", ".png", ".exr"}) {
      EXPECT_NE(status.error().hint.find(format), std::string::npos);
    }
    EXPECT_FALSE(std::filesystem::exists(folder / name));
  }
}

// A JPEG keeps flat colors to a code or two, and takes less for less quality.
TEST(EncodeJpeg, KeepsColorsAndTradesSize) {
  Image image(32, 32);
  for (int y = 0; y < 32; ++y) {
    for (int x = 0; x < 32; ++x) {
      image.at(x, y) =
          x < 16 ? Rgb(0.8f, 0.2f, 0.4f)
                 : Rgb(static_cast<float>((x * 7 + y * 13) % 32) / 32);
    }
  }
  const std::string fine = EncodeJpeg(image, 95).value();
  const std::string coarse = EncodeJpeg(image, 20).value();
  EXPECT_LT(coarse.size(), fine.size());
  EXPECT_EQ(EncodeJpeg(image, 95).value(), fine);
  const Image read = ReadLinearFromMemory(fine, "a.jpg").value();
  EXPECT_NEAR(SrgbEncode(read.at(4, 16).x), 0.8f, 3.0 / 255);
  EXPECT_NEAR(SrgbEncode(read.at(4, 16).y), 0.2f, 3.0 / 255);
  EXPECT_NEAR(SrgbEncode(read.at(4, 16).z), 0.4f, 3.0 / 255);
}

TEST(DisplayEncoded, ExposesEncodesAndClips) {
  Image image(2, 1);
  image.at(0, 0) = Rgb(0.25f, 0.5f, 3);
  image.at(1, 0) = Rgb(kNan, -1, kInf);
  const Image shown = DisplayEncoded(image, -1, false);
  EXPECT_FLOAT_EQ(shown.at(0, 0).x, SrgbEncode(0.125f));
  EXPECT_FLOAT_EQ(shown.at(0, 0).y, SrgbEncode(0.25f));
  EXPECT_FLOAT_EQ(shown.at(0, 0).z, 1);
  EXPECT_EQ(shown.at(1, 0).x, 0);
  EXPECT_EQ(shown.at(1, 0).y, 0);
  EXPECT_FLOAT_EQ(shown.at(1, 0).z, 1);
}

TEST(DisplayEncoded, RoundsToCodes) {
  Image image(1, 1);
  image.at(0, 0) = Rgb(0.18f);  // code 118: see the sRGB tests
  EXPECT_EQ(DisplayEncoded(image, 0, true).at(0, 0), Rgb(118.0f / 255));
  EXPECT_NEAR(DisplayEncoded(image, 0, false).at(0, 0).x, 0.461356, 1e-6);
}

TEST(DisplayEncoded, ExtremeExposures) {
  Image image(1, 1);
  image.at(0, 0) = Rgb(0, 1, 1e-9f);
  EXPECT_EQ(DisplayEncoded(image, 5000, true).at(0, 0), Rgb(0, 1, 1));
  EXPECT_EQ(DisplayEncoded(image, -5000, true).at(0, 0), Rgb(0));
}

}  // namespace
}  // namespace rtb
