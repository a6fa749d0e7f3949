#include "harness/error_maps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "core/color/srgb.h"
#include "harness/metrics/flip_map.h"

namespace rtb {
namespace {

constexpr std::array<Rgb8, 256> kMagma = {{
#include "harness/magma_table.inc"
}};

}  // namespace

Image FlipPicture(const MetricInput& input) {
  const ChannelPlane& map = FlipMap(input, kFlipPpd);
  Image picture(map.width(), map.height());
  std::ranges::transform(
      map.values(), picture.pixels().begin(), [](double error) {
        const auto step = static_cast<std::size_t>(std::lround(error * 255));
        return EncodedValues(kMagma[std::min(step, kMagma.size() - 1)]);
      });
  return picture;
}

Image DifferencePicture(const MetricInput& input) {
  Image picture(input.width(), input.height());
  std::ranges::transform(input.reference().pixels(), input.test().pixels(),
                         picture.pixels().begin(),
                         [](const Rgb& a, const Rgb& b) {
                           return Rgb(std::abs(a.x - b.x), std::abs(a.y - b.y),
                                      std::abs(a.z - b.z));
                         });
  return picture;
}

}  // namespace rtb
