/// @file
/// Reading and writing images, through OpenImageIO and as ASCII PPM.
#pragma once

#include <filesystem>
#include <string>

#include "core/base/result.h"
#include "core/image/image.h"

namespace rtb {

/// Reads any image OpenImageIO knows as scene-linear RGB: integer images are
/// sRGB-encoded and decoded exactly (8-bit codes survive a round trip, 16-bit
/// ones are not rounded first), float images are linear. Alpha is composited
/// over black in linear light, EXIF orientation is honored, gray becomes RGB.
Result<Image> ReadLinear(const std::filesystem::path& file);

/// The same from the bytes of a file (standard input); `name` names it.
Result<Image> ReadLinearFromMemory(const std::string& bytes,
                                   const std::string& name);

/// Reads the file's values as they are, such as heights: integer codes over
/// the largest code, without the sRGB decoding, floats unchanged. All else is
/// as for ReadLinear.
Result<Image> ReadValues(const std::filesystem::path& file);

/// Component type of an EXR file.
enum class ExrType { kHalf, kFloat };

/// Writes scene-linear pixels as EXR (ZIP, lossless).
Status WriteExr(const std::filesystem::path& file, const Image& linear,
                ExrType type);

/// The bytes of an 8-bit PNG of sRGB-encoded values in [0, 1].
Result<std::string> EncodePng(const Image& encoded);

/// Writes sRGB-encoded values in [0, 1] as 8-bit PNG.
Status WritePng(const std::filesystem::path& file, const Image& encoded);

/// The bytes of an 8-bit JPEG of sRGB-encoded values in [0, 1], colors at full
/// resolution. @param quality 1..100.
Result<std::string> EncodeJpeg(const Image& encoded, int quality);

/// ASCII PPM (P3, 255) of sRGB-encoded values in [0, 1]; at most 70 characters
/// a line, as the format asks.
std::string EncodePpm(const Image& encoded);

/// `.png` for `a/b.PNG`.
std::string LowerExtension(const std::filesystem::path& file);

/// Success when WriteRender knows the file's extension.
Status CheckRenderFile(const std::filesystem::path& file);

/// Writes by extension: .ppm and .png sRGB-encoded and clipped after
/// `exposure` stops, .exr (float) linear and unexposed. Any other extension
/// is an Error that lists these.
Status WriteRender(const std::filesystem::path& file, const Image& linear,
                   double exposure);

/// sRGB-encoded values of linear * 2^exposure, clipped to [0, 1].
/// @param round_to_8_bits whether values become multiples of 1/255.
Image DisplayEncoded(const Image& linear, double exposure,
                     bool round_to_8_bits);

}  // namespace rtb
