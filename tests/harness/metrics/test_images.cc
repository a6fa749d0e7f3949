#include "tests/harness/metrics/test_images.h"

#include <algorithm>
#include <cmath>

#include "core/image/io.h"
#include "core/math/random.h"

namespace rtb {
namespace {

/// A width x height image of color(x, y).
template <class Color>
Image Make(int width, int height, const Color& color) {
  Image out(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) out.at(x, y) = color(x, y);
  }
  return out;
}

}  // namespace

Image MetricImage(const std::string& name) {
  const auto linear = ReadLinear(std::string(RTB_TEST_SOURCE_DIR) +
                                 "/tests/data/metrics/" + name + ".png");
  RTB_CHECK(linear.has_value());
  return DisplayEncoded(*linear, 0, /*round_to_8_bits=*/true);
}

Image Pattern() {
  return Make(192, 176, [](int x, int y) {
    const float u = static_cast<float>(x) / 192;
    const float v = static_cast<float>(y) / 176;
    if (x / 24 % 2 == 0 && y / 44 % 2 == 0) return Rgb(0.8f, 0.3f * v, 0.1f);
    return Rgb(0.2f + 0.6f * u, 0.5f + 0.3f * std::sin(40 * u * v), 0.7f * v);
  });
}

Image Blurred(Image image, int times) {
  for (; times > 0; --times) {
    const int right = image.width() - 1;
    const int bottom = image.height() - 1;
    image = Make(right + 1, bottom + 1, [&](int x, int y) {
      Rgb sum(0);
      for (int k = 0; k < 9; ++k) {
        sum += image.at(std::clamp(x + k % 3 - 1, 0, right),
                        std::clamp(y + k / 3 - 1, 0, bottom));
      }
      return sum / 9.0f;
    });
  }
  return image;
}

Image Noisy(const Image& image, float amplitude) {
  return Make(image.width(), image.height(), [&](int x, int y) {
    Rgb color = image.at(x, y);
    const auto pixel = static_cast<std::uint32_t>(y * image.width() + x);
    for (std::uint32_t c = 0; c < 3; ++c) {
      const float noise = 2 * UnitFloat(RandomBits(pixel, 0, c, 1)) - 1;
      const int channel = static_cast<int>(c);
      color[channel] =
          std::clamp(color[channel] + amplitude * noise, 0.0f, 1.0f);
    }
    return color;
  });
}

Image MirroredX(const Image& image) {
  return Make(image.width(), image.height(),
              [&](int x, int y) { return image.at(image.width() - 1 - x, y); });
}

Image MirroredY(const Image& image) {
  return Make(image.width(), image.height(), [&](int x, int y) {
    return image.at(x, image.height() - 1 - y);
  });
}

Image Transposed(const Image& image) {
  return Make(image.height(), image.width(),
              [&](int x, int y) { return image.at(y, x); });
}

}  // namespace rtb
