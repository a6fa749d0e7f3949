#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <numeric>
#include <string>
#include <thread>
#include <vector>

#include "core/base/file.h"
#include "core/color/srgb.h"
#include "core/image/io.h"
#include "tests/core/image/image_files.h"
#include "tests/temp_folder.h"

namespace rtb {
namespace {

namespace fs = std::filesystem;

TEST(ReadLinear, EightBitCodesDecodeExactly) {
  const Image image = MustRead(Data("gray8.png"));
  ASSERT_EQ(image.width(), 256);
  for (int i = 0; i < 256; ++i) {
    const auto code = static_cast<std::uint8_t>(i);
    EXPECT_EQ(image.at(i, 0), Decode8({code, code, code}));
  }
}

TEST(ReadLinear, RowsRunDownwards) {
  const Image image = MustRead(Data("rgb8.png"));
  EXPECT_EQ(image.at(0, 0), Rgb(1, 0, 0));
  EXPECT_EQ(image.at(1, 0), Rgb(0, 1, 0));
  EXPECT_EQ(image.at(0, 1), Rgb(0, 0, 1));
  EXPECT_EQ(image.at(1, 1), Decode8({10, 20, 30}));
}

TEST(ReadLinear, OneBitGray) {
  const Image image = MustRead(Data("gray1.png"));
  EXPECT_EQ(image.at(0, 0), Rgb(0));
  EXPECT_EQ(image.at(1, 0), Rgb(1));
}

// 16-bit codes decode by the formula: 1000 / 65535 is below its linear part's
// end, so v / 12.92.
TEST(ReadLinear, SixteenBitCodesAreNotRounded) {
  const Rgb color = MustRead(Data("rgb16.png")).at(0, 0);
  EXPECT_FLOAT_EQ(color.x, static_cast<float>(1000 / 65535.0 / 12.92));
  EXPECT_FLOAT_EQ(color.y, static_cast<float>(1001 / 65535.0 / 12.92));
  EXPECT_FLOAT_EQ(color.z, 1);
}

TEST(ReadLinear, PaletteBecomesRgb) {
  const Image image = MustRead(Data("palette.png"));
  EXPECT_EQ(image.at(0, 0), Decode8({200, 100, 50}));
  EXPECT_EQ(image.at(1, 0), Decode8({1, 2, 3}));
}

// Over black in linear light: decoded, then multiplied.
TEST(ReadLinear, AlphaIsCompositedOverBlack) {
  constexpr float half = 128.0f / 255;
  const Rgb orange = Decode8({200, 100, 50});
  const Image rgba = MustRead(Data("rgba8.png"));
  EXPECT_EQ(rgba.at(0, 0), Decode8({10, 20, 30}));
  EXPECT_EQ(rgba.at(1, 0), orange * half);
  EXPECT_EQ(rgba.at(2, 0), Rgb(0));
  const Image gray = MustRead(Data("gray_alpha8.png"));
  EXPECT_EQ(gray.at(0, 0), Decode8({10, 10, 10}));
  EXPECT_EQ(gray.at(1, 0), Decode8({200, 200, 200}) * half);
  const Image palette = MustRead(Data("palette_alpha.png"));
  EXPECT_EQ(palette.at(0, 0), orange * half);
  EXPECT_EQ(palette.at(1, 0), Decode8({1, 2, 3}));
  const Image color = MustRead(Data("transparent_color.png"));
  EXPECT_EQ(color.at(0, 0), Rgb(0));
  EXPECT_EQ(color.at(1, 0), orange);
  const Rgb deep = MustRead(Data("rgba16.png")).at(0, 0);
  EXPECT_FLOAT_EQ(deep.x,
                  static_cast<float>(1000 / 65535.0 / 12.92 * 32768 / 65535.0));
}

TEST(ReadLinear, ExrAlphaIsAlreadyMultiplied) {
  const TempFolder folder;
  Write(folder / "a.exr", Named(1, 1, {"R", "G", "B", "A"}),
        {0.5f, 2, -1, 0.25f});
  EXPECT_EQ(MustRead(folder / "a.exr").at(0, 0), Rgb(0.5f, 2, -1));
}

TEST(ReadLinear, ChannelsGoByName) {
  const TempFolder folder;
  Write(folder / "a.exr", Named(1, 1, {"Z", "B", "A", "R", "G"}),
        {9, 3, 0.5f, 1, 2});
  EXPECT_EQ(MustRead(folder / "a.exr").at(0, 0), Rgb(1, 2, 3));
  Write(folder / "layers.exr",
        Named(1, 1,
              {"View.Depth.Z", "View.Color.A", "View.Color.B", "View.Color.G",
               "View.Color.R"}),
        {9, 1, 3, 2, 1});
  EXPECT_EQ(MustRead(folder / "layers.exr").at(0, 0), Rgb(1, 2, 3));
  Write(folder / "gray.exr", Named(1, 1, {"Y"}), {0.75f});
  EXPECT_EQ(MustRead(folder / "gray.exr").at(0, 0), Rgb(0.75f));
}

// A data window of 2 x 2 at (1, 2) on a display window of 4 x 3 at (0, 1):
// it lies one pixel from the left and from the top, and nothing is cut.
TEST(ReadLinear, DataWindowLiesOnTheDisplayWindow) {
  const TempFolder folder;
  OIIO::ImageSpec spec = Named(2, 2, {"R", "G", "B"});
  spec.x = 1;
  spec.y = 2;
  spec.full_x = 0;
  spec.full_y = 1;
  spec.full_width = 4;
  spec.full_height = 3;
  Write(folder / "a.exr", spec, {1, 1, 1, 2, 2, 2, 3, 3, 3, 4, 4, 4});
  const Image image = MustRead(folder / "a.exr");
  const float expected[3][4] = {{0, 0, 0, 0}, {0, 1, 2, 0}, {0, 3, 4, 0}};
  ASSERT_EQ(image.width(), 4);
  ASSERT_EQ(image.height(), 3);
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 4; ++x) {
      EXPECT_EQ(image.at(x, y), Rgb(expected[y][x])) << x << " " << y;
    }
  }
}

// The data window sticks out on all sides: only its middle is shown.
TEST(ReadLinear, DataOutsideTheDisplayWindowIsCut) {
  const TempFolder folder;
  OIIO::ImageSpec spec = Named(3, 3, {"Y"});
  spec.x = spec.y = -1;
  spec.full_width = spec.full_height = 1;
  Write(folder / "a.exr", spec, {1, 2, 3, 4, 5, 6, 7, 8, 9});
  const Image image = MustRead(folder / "a.exr");
  ASSERT_EQ(image.pixels().size(), 1u);
  EXPECT_EQ(image.at(0, 0), Rgb(5));
}

// More rows than are read at once, and tiles that do not divide the size.
TEST(ReadLinear, LargeAndTiledImages) {
  const TempFolder folder;
  OIIO::ImageSpec spec = Named(75, 210, {"R", "G", "B"});
  std::vector<float> values(75 * 210 * 3);
  std::iota(values.begin(), values.end(), 0.0f);
  for (const int tile : {0, 32}) {
    spec.tile_width = spec.tile_height = tile;
    Write(folder / "a.exr", spec, values);
    const Image image = MustRead(folder / "a.exr");
    ASSERT_EQ(image.pixels().size(), 75u * 210);
    for (std::size_t i = 0; i < image.pixels().size(); ++i) {
      ASSERT_EQ(image.pixels()[i].y, values[i * 3 + 1]);
    }
  }
}

// The eight cases themselves are the orientation tests'; here the attribute
// reaches them from files of two kinds.
TEST(ReadLinear, HonorsTheOrientation) {
  const TempFolder folder;
  for (int orientation = 1; orientation <= 8; ++orientation) {
    OIIO::ImageSpec spec(2, 1, 1, OIIO::TypeDesc::UINT8);
    spec.attribute("Orientation", orientation);
    spec.attribute("compression", "none");  // else it is done on a thread
    Write(folder / "a.tif", spec, {0, 1});
    const Image image = MustRead(folder / "a.tif");
    EXPECT_EQ(image.width(), orientation < 5 ? 2 : 1);
    // White, the right one, comes first when right and left (2, 3) or, once
    // rows are columns, top and bottom (7, 8) change places.
    const bool first = orientation == 2 || orientation == 3 ||
                       orientation == 7 || orientation == 8;
    EXPECT_EQ(image.at(0, 0), Rgb(first ? 1.0f : 0.0f)) << orientation;
  }
}

// Turned clockwise, the left half of the stored image is the upper one.
TEST(ReadLinear, HonorsTheOrientationOfJpegs) {
  const TempFolder folder;
  OIIO::ImageSpec spec(32, 16, 1, OIIO::TypeDesc::UINT8);
  spec.attribute("Orientation", 6);
  std::vector<float> values;
  for (int i = 0; i < 32 * 16; ++i) values.push_back(i % 32 < 16 ? 1 : 0);
  Write(folder / "a.jpg", spec, values);
  const Image image = MustRead(folder / "a.jpg");
  ASSERT_EQ(image.width(), 16);
  ASSERT_EQ(image.height(), 32);
  EXPECT_GT(image.at(8, 4).x, 0.9f);
  EXPECT_LT(image.at(8, 28).x, 0.1f);
}

TEST(ReadLinear, ExtensionsMayLie) {
  const TempFolder folder;
  for (const char* name : {"a.jpg", "a", "a?b.png", "a b.exr"}) {
    fs::copy_file(Data("rgb8.png"), folder / name);
    EXPECT_EQ(MustRead(folder / name).at(0, 0), Rgb(1, 0, 0)) << name;
  }
}

TEST(ReadLinear, ReadsPipes) {
  const TempFolder folder;
  const fs::path fifo = folder / "fifo";
  ASSERT_EQ(::mkfifo(fifo.c_str(), 0600), 0);
  std::thread writer([&] {
    EXPECT_TRUE(WriteFileAtomically(fifo, ReadFile(Data("rgb8.png")).value()));
  });
  const auto image = ReadLinear(fifo);
  writer.join();
  ASSERT_TRUE(image) << image.error().ToString();
  EXPECT_EQ(image->at(0, 0), Rgb(1, 0, 0));
}

}  // namespace
}  // namespace rtb
