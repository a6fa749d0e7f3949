#include "encoders/palette.h"

#include <algorithm>
#include <array>
#include <vector>

#include "core/base/check.h"

namespace rtb {
namespace {

constexpr std::array<Rgb8, 16> kAnsi = {{{0, 0, 0},
                                         {205, 0, 0},
                                         {0, 205, 0},
                                         {205, 205, 0},
                                         {0, 0, 238},
                                         {205, 0, 205},
                                         {0, 205, 205},
                                         {229, 229, 229},
                                         {127, 127, 127},
                                         {255, 0, 0},
                                         {0, 255, 0},
                                         {255, 255, 0},
                                         {92, 92, 255},
                                         {255, 0, 255},
                                         {0, 255, 255},
                                         {255, 255, 255}}};
constexpr int kCube = 16;
constexpr int kGrays = kCube + 6 * 6 * 6;

/// A level of the cube: 0, 95, 135, 175, 215, 255.
std::uint8_t CubeLevel(int step) {
  return static_cast<std::uint8_t>(step == 0 ? 0 : 55 + 40 * step);
}

constexpr std::array<Rgb8, 2> kMonoColors = {kDefaultForeground,
                                             kDefaultBackground};

std::vector<Rgb8> CubeAndGrays() {
  std::vector<Rgb8> colors;
  for (int index = kCube; index < 256; ++index) {
    colors.push_back(XtermColor(index));
  }
  return colors;
}

}  // namespace

Rgb8 XtermColor(int index) {
  RTB_CHECK_GE(index, 0);
  RTB_CHECK_LT(index, 256);
  if (index < kCube) return kAnsi[static_cast<std::size_t>(index)];
  if (index < kGrays) {
    const int cube = index - kCube;
    return {CubeLevel(cube / 36), CubeLevel(cube / 6 % 6), CubeLevel(cube % 6)};
  }
  const auto gray = static_cast<std::uint8_t>(8 + 10 * (index - kGrays));
  return {gray, gray, gray};
}

std::span<const Rgb8> PaletteColors(ColorDepth depth) {
  static const std::vector<Rgb8> cube_and_grays = CubeAndGrays();
  switch (depth) {
    case ColorDepth::k256:
      return cube_and_grays;
    case ColorDepth::k16:
      return kAnsi;
    case ColorDepth::kMono:
      return kMonoColors;
    default:
      return {};
  }
}

std::optional<int> IndexOf(Rgb8 color, ColorDepth depth) {
  if (depth != ColorDepth::k256 && depth != ColorDepth::k16) return {};
  const std::span<const Rgb8> colors = PaletteColors(depth);
  const auto found = std::ranges::find(colors, color);
  if (found == colors.end()) return {};
  const int first = depth == ColorDepth::k256 ? kCube : 0;
  return first + static_cast<int>(found - colors.begin());
}

}  // namespace rtb
