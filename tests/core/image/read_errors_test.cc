#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/file.h"
#include "core/image/io.h"
#include "tests/core/image/image_files.h"
#include "tests/temp_folder.h"

namespace rtb {
namespace {

namespace fs = std::filesystem;

TEST(ReadLinearErrors, WhatIsNoImageIsAnError) {
  const TempFolder folder;
  for (const char* name : {"a.png", "a.exr", "a.jpg", "a.tif", "a"}) {
    const fs::path file = folder / name;
    for (const std::string& bytes :
         {std::string(), std::string("no image"), std::string(5000, '\0'),
          std::string("\x89PNG\r\n\x1a\n"), std::string("\x76\x2f\x31\x01")}) {
      ASSERT_TRUE(WriteFileAtomically(file, bytes));
      ExpectBadInput(ReadLinear(file), file.string());
      ExpectBadInput(ReadLinearFromMemory(bytes, "standard input"),
                     "standard input");
    }
  }
  ExpectBadInput(ReadLinear(folder / "missing.png"),
                 (folder / "missing.png").string());
  ExpectBadInput(ReadLinear(folder.path()), folder.path().string());
}

TEST(ReadLinearErrors, ImpossibleSizesAreErrors) {
  ExpectBadInput(Read(Data("zero_width.png")), Data("zero_width.png").string());
  const auto large = Read(Data("too_large.png"));
  ExpectBadInput(large, Data("too_large.png").string());
  EXPECT_NE(large.error().what.find("16384x16385"), std::string::npos);
  const TempFolder folder;
  OIIO::ImageSpec spec = Named(1, 1, {"Y"});
  spec.full_width = spec.full_height = 1 << 20;
  Write(folder / "a.exr", spec, {1});
  ExpectBadInput(Read(folder / "a.exr"), (folder / "a.exr").string());
}

// Cut anywhere, a file is an error or, where only a trailer is lost, the
// whole image; never a crash nor half an image.
TEST(ReadLinearErrors, TruncatedFilesAreErrors) {
  const TempFolder folder;
  Image noise(40, 40);
  unsigned state = 1;
  for (Rgb& color : noise.pixels()) {
    state = state * 1664525u + 1013904223u;
    color = Rgb(static_cast<float>(state >> 8) * 0x1p-24f);
  }
  ASSERT_TRUE(WritePng(folder / "a.png", noise));
  ASSERT_TRUE(WriteExr(folder / "a.exr", noise, ExrType::kHalf));
  Write(folder / "a.jpg", OIIO::ImageSpec(40, 40, 3, OIIO::TypeDesc::UINT8),
        std::vector<float>(40 * 40 * 3, 0.5f));
  for (const char* name : {"a.png", "a.exr", "a.jpg"}) {
    const std::string bytes = ReadFile(folder / name).value();
    const fs::path cut = folder / (std::string("cut_") + name);
    for (int part = 0; part < 20; ++part) {
      const std::size_t size =
          bytes.size() * static_cast<std::size_t>(part) / 20;
      ASSERT_TRUE(WriteFileAtomically(cut, bytes.substr(0, size)));
      ExpectBadInput(ReadLinear(cut), cut.string());
    }
  }
}

TEST(ReadLinearFromMemory, ErrorsNameTheSource) {
  const auto image = ReadLinearFromMemory(
      ReadFile(Data("rgb8.png")).value().substr(0, 60), "standard input");
  ExpectBadInput(image, "standard input");
  EXPECT_EQ(image.error().ToString().find("/proc"), std::string::npos);
}

}  // namespace
}  // namespace rtb
