#include "encoders/palette.h"

#include <array>

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

}  // namespace rtb
