#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <cmath>
#include <cstdint>
#include <exception>
#include <string_view>
#include <vector>

#include "core/base/file.h"
#include "core/color/srgb.h"
#include "core/image/io.h"

namespace rtb {
namespace {

/// The bytes of a file in the format of the extension `name` ends in.
/// @param pixels RGB triples of the component type `memory`.
Result<std::vector<unsigned char>> Encode(const std::string& name,
                                          const OIIO::ImageSpec& spec,
                                          OIIO::TypeDesc memory,
                                          const void* pixels) try {
  std::vector<unsigned char> bytes;
  OIIO::Filesystem::IOVecOutput proxy(bytes);
  const auto output = OIIO::ImageOutput::create(name, &proxy);
  if (!output) return Fail(Missing(name, OIIO::geterror()));
  output->threads(1);  // no threads but those that a caller asked for
  const bool written = output->open(name, spec) &&
                       output->write_image(memory, pixels) && output->close();
  if (!written) return Fail(Failure(name, output->geterror()));
  return bytes;
} catch (const std::exception& error) {
  return Fail(Failure(name, error.what()));
}

Status WriteEncoded(const std::filesystem::path& file,
                    const std::string& format_name, const OIIO::ImageSpec& spec,
                    OIIO::TypeDesc memory, const void* pixels) {
  if (spec.width < 1 || spec.height < 1) {
    return Fail(BadInput(file.string(), "an image without pixels has no file"));
  }
  auto bytes = Encode(format_name, spec, memory, pixels);
  if (!bytes) {
    bytes.error().place = file.string();
    return Fail(std::move(bytes.error()));
  }
  return WriteFileAtomically(
      file, std::string_view(reinterpret_cast<const char*>(bytes->data()),
                             bytes->size()));
}

}  // namespace

Status WriteExr(const std::filesystem::path& file, const Image& linear,
                ExrType type) {
  OIIO::ImageSpec spec(
      linear.width(), linear.height(), 3,
      type == ExrType::kHalf ? OIIO::TypeDesc::HALF : OIIO::TypeDesc::FLOAT);
  spec.attribute("compression", "zip");
  // Without it the time of writing goes in: no two files would be the same.
  spec.attribute("DateTime", "");
  static_assert(sizeof(Rgb) == 3 * sizeof(float));
  return WriteEncoded(file, "image.exr", spec, OIIO::TypeDesc::FLOAT,
                      linear.pixels().data());
}

Status WritePng(const std::filesystem::path& file, const Image& encoded) {
  std::vector<Rgb8> codes;
  codes.reserve(encoded.pixels().size());
  for (const Rgb& color : encoded.pixels()) {
    codes.push_back(QuantizeEncoded(color));
  }
  static_assert(sizeof(Rgb8) == 3);
  const OIIO::ImageSpec spec(encoded.width(), encoded.height(), 3,
                             OIIO::TypeDesc::UINT8);
  return WriteEncoded(file, "image.png", spec, OIIO::TypeDesc::UINT8,
                      codes.data());
}

}  // namespace rtb
