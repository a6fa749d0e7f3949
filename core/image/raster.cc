#include "core/image/raster.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace rtb {
namespace {

constexpr std::int64_t kMostPixels = std::int64_t{1} << 28;
constexpr int kRowsAtOnce = 64;

/// A rectangle of pixels.
struct Window {
  std::int64_t x, y, width, height;
};

Status CheckSize(const Window& window, const std::string& name) {
  const std::string size =
      std::to_string(window.width) + "x" + std::to_string(window.height);
  if (window.width < 1 || window.height < 1) {
    return Fail(BadInput(name, "is an image of " + size + " pixels"));
  }
  if (window.width > kMostPixels / window.height) {
    return Fail(BadInput(name, "is an image of " + size +
                                   " pixels, more than the " +
                                   std::to_string(kMostPixels) + " accepted"));
  }
  return {};
}

/// What is shown. Other formats use OpenImageIO's full window for prints and
/// textures; there the raster itself is what is shown.
Window Display(const OIIO::ImageSpec& spec, const Window& data, bool is_exr) {
  if (!is_exr) return data;
  return {spec.full_x, spec.full_y, spec.full_width, spec.full_height};
}

/// Reads rows [y, y + count) of the data window, in the file's coordinates.
bool ReadRows(OIIO::ImageInput& input, const OIIO::ImageSpec& spec,
              const PixelDecoder& decoder, int y, int count,
              std::vector<float>* values) {
  if (spec.tile_width == 0) {
    return input.read_scanlines(0, 0, y, y + count, spec.z, decoder.begin(),
                                decoder.end(), OIIO::TypeDesc::FLOAT,
                                values->data());
  }
  return input.read_tiles(0, 0, spec.x, spec.x + spec.width, y, y + count,
                          spec.z, spec.z + 1, decoder.begin(), decoder.end(),
                          OIIO::TypeDesc::FLOAT, values->data());
}

/// Decodes one row onto the image, at `x` (which may lie outside).
void PlaceRow(const PixelDecoder& decoder, std::span<const float> values,
              std::int64_t x, int y, Image* image) {
  const auto channels =
      static_cast<std::size_t>(decoder.end() - decoder.begin());
  for (std::size_t i = 0; i * channels < values.size(); ++i) {
    const std::int64_t column = x + static_cast<std::int64_t>(i);
    if (column < 0 || column >= image->width()) continue;
    image->at(static_cast<int>(column), y) =
        decoder.Linear(values.subspan(i * channels, channels));
  }
}

/// Reads everything, some rows at a time, onto the part of the image that
/// `shown` is of the file's plane.
/// @return whether the file was whole.
bool ReadOnto(OIIO::ImageInput& input, const OIIO::ImageSpec& spec,
              const Window& shown, Codes codes, Image* image) {
  const PixelDecoder decoder(spec, codes);
  const auto row_size =
      static_cast<std::size_t>(spec.width) *
      static_cast<std::size_t>(decoder.end() - decoder.begin());
  const int step = spec.tile_width == 0 ? kRowsAtOnce : spec.tile_height;
  std::vector<float> values(
      row_size * static_cast<std::size_t>(std::min(step, spec.height)));
  for (int row = 0; row < spec.height; row += step) {
    const int count = std::min(step, spec.height - row);
    // Some readers fill in what is missing, and only mention it.
    if (!ReadRows(input, spec, decoder, spec.y + row, count, &values) ||
        input.has_error()) {
      return false;
    }
    for (int i = 0; i < count; ++i) {
      const std::int64_t y = std::int64_t{spec.y} + row + i - shown.y;
      if (y < 0 || y >= image->height()) continue;
      const auto begin = static_cast<std::size_t>(i) * row_size;
      PlaceRow(decoder, std::span(values).subspan(begin, row_size),
               spec.x - shown.x, static_cast<int>(y), image);
    }
  }
  return true;
}

}  // namespace

Result<Image> ReadRaster(OIIO::ImageInput& input, const std::string& name,
                         Codes codes) {
  const OIIO::ImageSpec spec = input.spec();
  if (spec.deep || spec.nchannels < 1) {
    return Fail(BadInput(name, "holds no flat color image"));
  }
  const Window data{spec.x, spec.y, spec.width, spec.height};
  const Window shown =
      Display(spec, data, std::string(input.format_name()) == "openexr");
  RTB_RETURN_IF_ERROR(CheckSize(data, name));
  RTB_RETURN_IF_ERROR(CheckSize(shown, name));
  Image image(static_cast<int>(shown.width), static_cast<int>(shown.height));
  if (!ReadOnto(input, spec, shown, codes, &image)) {
    return Fail(BadInput(name, "is damaged: " + input.geterror()));
  }
  return image;
}

}  // namespace rtb
