#include <algorithm>
#include <cctype>
#include <cmath>

#include "core/base/file.h"
#include "core/color/srgb.h"
#include "core/image/io.h"

namespace rtb {
std::string LowerExtension(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  std::transform(
      extension.begin(), extension.end(), extension.begin(),
      [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

Image DisplayEncoded(const Image& linear, double exposure,
                     bool round_to_8_bits) {
  const float gain = std::exp2(static_cast<float>(exposure));
  Image encoded(linear.width(), linear.height());
  std::transform(linear.pixels().begin(), linear.pixels().end(),
                 encoded.pixels().begin(), [&](const Rgb& color) {
                   const Rgb light = color * gain;
                   return round_to_8_bits ? EncodedValues(Encode8(light))
                                          : light;
                 });
  if (!round_to_8_bits) SrgbEncode(encoded.pixels(), encoded.pixels());
  return encoded;
}

Status CheckRenderFile(const std::filesystem::path& file) {
  const std::string extension = LowerExtension(file);
  if (extension == ".exr" || extension == ".png" || extension == ".ppm") {
    return {};
  }
  return Fail(BadInput(file.string(), "has the extension '" + extension + "'",
                       "the formats are .ppm, .png and .exr"));
}

Status WriteRender(const std::filesystem::path& file, const Image& linear,
                   double exposure) {
  RTB_RETURN_IF_ERROR(CheckRenderFile(file));
  const std::string extension = LowerExtension(file);
  if (extension == ".exr") return WriteExr(file, linear, ExrType::kFloat);
  const Image encoded = DisplayEncoded(linear, exposure, true);
  if (extension == ".png") return WritePng(file, encoded);
  return WriteFileAtomically(file, EncodePpm(encoded));
}

}  // namespace rtb
