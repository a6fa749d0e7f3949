/// @file
/// Image files for tests: those committed, and those written on the spot.
#pragma once

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "core/base/file.h"
#include "core/image/io.h"

namespace rtb {

/// A committed file.
inline std::filesystem::path Data(const std::string& name) {
  return std::filesystem::path(RTB_TEST_SOURCE_DIR) / "tests/data/images" /
         name;
}

/// Reads a file both ways, which must agree.
inline Result<Image> Read(const std::filesystem::path& file) {
  auto image = ReadLinear(file);
  const auto again = ReadLinearFromMemory(ReadFile(file).value(), "memory");
  EXPECT_EQ(image.has_value(), again.has_value());
  if (image && again) {
    EXPECT_TRUE(std::ranges::equal(image->pixels(), again->pixels()));
  }
  return image;
}

/// The image, or a failure of the test and a black one.
inline Image MustRead(const std::filesystem::path& file) {
  auto image = Read(file);
  EXPECT_TRUE(image) << image.error().ToString();
  return image ? *std::move(image) : Image(8, 8);
}

/// Writes a file of any kind, from float values.
inline void Write(const std::filesystem::path& file,
                  const OIIO::ImageSpec& spec,
                  const std::vector<float>& values) {
  const auto output = OIIO::ImageOutput::create(file.string());
  ASSERT_TRUE(output) << OIIO::geterror();
  output->threads(1);
  ASSERT_TRUE(output->open(file.string(), spec)) << output->geterror();
  if (spec.tile_width > 0) {
    ASSERT_TRUE(output->write_tiles(spec.x, spec.x + spec.width, spec.y,
                                    spec.y + spec.height, spec.z, spec.z + 1,
                                    OIIO::TypeDesc::FLOAT, values.data()));
  } else {
    ASSERT_TRUE(output->write_image(OIIO::TypeDesc::FLOAT, values.data()));
  }
  ASSERT_TRUE(output->close()) << output->geterror();
}

/// A float or half spec with the channels named.
inline OIIO::ImageSpec Named(int width, int height,
                             const std::vector<std::string>& names) {
  OIIO::ImageSpec spec(width, height, static_cast<int>(names.size()),
                       OIIO::TypeDesc::FLOAT);
  spec.channelnames = names;
  return spec;
}

/// Expects an Error that blames what `place` names.
inline void ExpectBadInput(const Result<Image>& image,
                           const std::string& place) {
  ASSERT_FALSE(image);
  EXPECT_EQ(image.error().kind, ErrorKind::kBadInput);
  EXPECT_EQ(image.error().place, place);
  EXPECT_FALSE(image.error().what.empty());
}

}  // namespace rtb
