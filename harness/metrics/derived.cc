#include "harness/metrics/derived.h"

#include <array>
#include <cmath>

#include "core/color/luminance.h"
#include "core/color/srgb.h"
#include "harness/metrics/rows.h"

namespace rtb {
namespace {

/// sRGB decoding with a table for the 8-bit codes, which most values are.
class Decoder {
 public:
  Decoder() {
    for (std::size_t code = 0; code < codes_.size(); ++code) {
      codes_[code] = SrgbDecode(static_cast<double>(code) / 255);
    }
  }

  double operator()(float encoded) const {
    const std::uint8_t code = QuantizeEncoded(encoded);
    if (static_cast<float>(code) / 255 == encoded) return codes_[code];
    return SrgbDecode(static_cast<double>(encoded));
  }

 private:
  std::array<double, 256> codes_{};
};

ColorPlanes ToLinear(const Image& image, int threads) {
  static const Decoder decode;
  const ChannelPlane plane(image.width(), image.height());
  ColorPlanes out = {plane, plane, plane};
  ForRows(image.height(), threads, [&](int y) {
    for (int x = 0; x < image.width(); ++x) {
      const Rgb& pixel = image.at(x, y);
      out[0].row(y)[x] = decode(pixel.x);
      out[1].row(y)[x] = decode(pixel.y);
      out[2].row(y)[x] = decode(pixel.z);
    }
  });
  return out;
}

ChannelPlane ToLuma(const Image& image, int threads) {
  ChannelPlane out(image.width(), image.height());
  ForRows(image.height(), threads, [&](int y) {
    for (int x = 0; x < image.width(); ++x) {
      out.row(y)[x] = Luminance(V3d(image.at(x, y)));
    }
  });
  return out;
}

}  // namespace

const OfBoth<ColorPlanes>& LinearPlanes(const MetricInput& input) {
  return input.Once<OfBoth<ColorPlanes>>("linear", [&] {
    return OfBoth<ColorPlanes>{ToLinear(input.reference(), input.threads()),
                               ToLinear(input.test(), input.threads())};
  });
}

const OfBoth<ChannelPlane>& LumaPlanes(const MetricInput& input) {
  return input.Once<OfBoth<ChannelPlane>>("luma", [&] {
    return OfBoth<ChannelPlane>{ToLuma(input.reference(), input.threads()),
                                ToLuma(input.test(), input.threads())};
  });
}

}  // namespace rtb
