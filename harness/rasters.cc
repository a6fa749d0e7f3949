#include "harness/rasters.h"

#include <algorithm>
#include <cmath>

#include "core/color/srgb.h"
#include "core/image/io.h"
#include "core/image/resample.h"

namespace rtb {
namespace {

/// Largest relative difference of two aspects that count as one picture.
constexpr double kAspectTolerance = 1e-3;

PixelSize SizeOf(const Image& image) { return {image.width(), image.height()}; }

std::string Text(PixelSize size) {
  return std::to_string(size.width) + "x" + std::to_string(size.height);
}

/// Encoded values at another size, averaged in linear light.
Image Reduce(const Image& encoded, PixelSize size) {
  if (SizeOf(encoded) == size) return encoded;
  return DisplayEncoded(ResizeArea(LinearOf(encoded), size.width, size.height),
                        0, false);
}

}  // namespace

bool HoldsLinearLight(const std::filesystem::path& file) {
  const std::string extension = LowerExtension(file);
  return extension == ".exr" || extension == ".hdr" || extension == ".pfm";
}

Image LinearOf(const Image& encoded) {
  Image linear = encoded;
  for (Rgb& pixel : linear.pixels()) {
    pixel = Rgb(SrgbDecode(pixel.x), SrgbDecode(pixel.y), SrgbDecode(pixel.z));
  }
  return linear;
}

Result<Image> ReadDisplayed(const std::filesystem::path& file,
                            double exposure) {
  RTB_ASSIGN_OR_RETURN(const Image linear, ReadLinear(file));
  return DisplayEncoded(linear, HoldsLinearLight(file) ? exposure : 0, true);
}

Status CheckAspects(PixelSize reference, PixelSize test,
                    const std::string& place) {
  const auto aspect = [](PixelSize size) {
    return static_cast<double>(size.width) / size.height;
  };
  const double ratio = aspect(reference) / aspect(test);
  if (std::abs(ratio - 1) <= kAspectTolerance) return {};
  return Fail(BadInput(place, "found " + Text(reference) +
                                  " pixels to compare with " + Text(test) +
                                  ", expected the same aspect within 0.1 %"));
}

Result<RasterPair> MatchRasters(const Image& reference, const Image& test,
                                const std::string& place) {
  RasterPair pair;
  pair.reference_size = SizeOf(reference);
  pair.test_size = SizeOf(test);
  RTB_RETURN_IF_ERROR(CheckAspects(pair.reference_size, pair.test_size, place));
  const PixelSize size = {std::min(reference.width(), test.width()),
                          std::min(reference.height(), test.height())};
  pair.reference = Reduce(reference, size);
  pair.test = Reduce(test, size);
  return pair;
}

}  // namespace rtb
