#include "core/image/channels.h"

#include <OpenImageIO/strutil.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/color/srgb.h"

namespace rtb {
namespace {

std::vector<std::string> LowerNames(const OIIO::ImageSpec& spec) {
  std::vector<std::string> names;
  for (const std::string& name : spec.channelnames) {
    names.push_back(OIIO::Strutil::lower(name));
  }
  names.resize(static_cast<std::size_t>(spec.nchannels));
  return names;
}

/// The index of a name, or -1.
int Find(const std::vector<std::string>& names, const std::string& name) {
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? -1 : static_cast<int>(found - names.begin());
}

/// Channel indices; alpha is -1 where there is none.
struct ColorChannels {
  int red, green, blue, alpha;
};

ColorChannels Locate(const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    // A layer's channels are called `layer.R`; the plain layer has no name.
    const auto dot = name.rfind('.');
    const std::string layer =
        dot == std::string::npos ? "" : name.substr(0, dot + 1);
    const ColorChannels color{
        Find(names, layer + "r"), Find(names, layer + "g"),
        Find(names, layer + "b"), Find(names, layer + "a")};
    if (std::min({color.red, color.green, color.blue}) >= 0) return color;
  }
  const int alpha = Find(names, "a");
  const int y = Find(names, "y");
  if (y < 0 && names.size() >= 3) return {0, 1, 2, alpha};
  const int gray = std::max(y, 0);
  return {gray, gray, gray, alpha};
}

}  // namespace

PixelDecoder::PixelDecoder(const OIIO::ImageSpec& spec, Codes codes)
    : coding_(codes == Codes::kValues || spec.format.is_floating_point()
                  ? Coding::kLinear
              : spec.format == OIIO::TypeDesc(OIIO::TypeDesc::UINT8)
                  ? Coding::kCodes8
                  : Coding::kEncoded) {
  const ColorChannels color = Locate(LowerNames(spec));
  const auto [least, most] = std::minmax({color.red, color.green, color.blue});
  begin_ = least;
  end_ = most + 1;
  const bool multiply =
      color.alpha >= 0 && spec.get_int_attribute("oiio:UnassociatedAlpha") != 0;
  if (multiply) {
    begin_ = std::min(begin_, color.alpha);
    end_ = std::max(end_, color.alpha + 1);
    alpha_ = color.alpha - begin_;
  }
  red_ = color.red - begin_;
  green_ = color.green - begin_;
  blue_ = color.blue - begin_;
}

float PixelDecoder::Decode(float value) const {
  switch (coding_) {
    case Coding::kCodes8:
      return SrgbDecode8(static_cast<std::uint8_t>(std::lround(value * 255)));
    case Coding::kEncoded:
      return SrgbDecode(value);
    case Coding::kLinear:
      break;
  }
  return value;
}

Rgb PixelDecoder::Linear(std::span<const float> values) const {
  const auto value = [&](int channel) {
    return values[static_cast<std::size_t>(channel)];
  };
  const Rgb color(Decode(value(red_)), Decode(value(green_)),
                  Decode(value(blue_)));
  return alpha_ < 0 ? color : color * value(alpha_);
}

}  // namespace rtb
