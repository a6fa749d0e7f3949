#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <cmath>
#include <cstdint>
#include <exception>
#include <string>
#include <utility>
#include <vector>

#include "core/base/file.h"
#include "core/color/srgb.h"
#include "core/image/io.h"

namespace rtb {
namespace {

/// The bytes of a file in the format of the extension `name` ends in.
/// @param pixels RGB triples of the component type `memory`.
Result<std::string> Encode(const std::string& name, const OIIO::ImageSpec& spec,
                           OIIO::TypeDesc memory, const void* pixels) try {
  if (spec.width < 1 || spec.height < 1) {
    return Fail(BadInput(name, "an image without pixels has no file"));
  }
  std::vector<unsigned char> bytes;
  OIIO::Filesystem::IOVecOutput proxy(bytes);
  const auto output = OIIO::ImageOutput::create(name, &proxy);
  if (!output) return Fail(Missing(name, OIIO::geterror()));
  output->threads(1);  // no threads but those that a caller asked for
  const bool written = output->open(name, spec) &&
                       output->write_image(memory, pixels) && output->close();
  if (!written) return Fail(Failure(name, output->geterror()));
  return std::string(bytes.begin(), bytes.end());
} catch (const std::exception& error) {
  return Fail(Failure(name, error.what()));
}

/// Encodes 8-bit codes, by the attributes of `spec`.
Result<std::string> EncodeCodes(const std::string& name, OIIO::ImageSpec spec,
                                const Image& encoded) {
  std::vector<Rgb8> codes;
  codes.reserve(encoded.pixels().size());
  for (const Rgb& color : encoded.pixels()) {
    codes.push_back(QuantizeEncoded(color));
  }
  static_assert(sizeof(Rgb8) == 3);
  spec.width = spec.full_width = encoded.width();
  spec.height = spec.full_height = encoded.height();
  spec.nchannels = 3;
  spec.set_format(OIIO::TypeDesc::UINT8);
  spec.default_channel_names();
  return Encode(name, spec, OIIO::TypeDesc::UINT8, codes.data());
}

/// Writes what Encode made; its errors are about the file.
Status WriteEncoded(const std::filesystem::path& file,
                    Result<std::string> bytes) {
  if (bytes) return WriteFileAtomically(file, *bytes);
  bytes.error().place = file.string();
  return Fail(std::move(bytes.error()));
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
  return WriteEncoded(file, Encode("image.exr", spec, OIIO::TypeDesc::FLOAT,
                                   linear.pixels().data()));
}

Result<std::string> EncodePng(const Image& encoded) {
  return EncodeCodes("image.png", {}, encoded);
}

Result<std::string> EncodeJpeg(const Image& encoded, int quality) {
  OIIO::ImageSpec spec;
  spec.attribute("Compression", "jpeg:" + std::to_string(quality));
  spec.attribute("jpeg:subsampling", "4:4:4");
  return EncodeCodes("image.jpg", spec, encoded);
}

Status WritePng(const std::filesystem::path& file, const Image& encoded) {
  return WriteEncoded(file, EncodePng(encoded));
}

}  // namespace rtb
