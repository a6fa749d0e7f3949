/// @file
/// Latitude-longitude environment images: lookup and importance sampling, host
/// and device. environment_load.h builds them.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/host_device.h"
#include "core/math/constants.h"
#include "core/math/discrete.h"
#include "core/math/sin_cos.h"
#include "core/math/vec.h"
#include "core/shading/texture.h"

namespace rtb {

/// Radiance from all directions: +y up, -z at the image's center, +x to the
/// right of it; and a distribution that is constant over the solid angle of
/// each texel, proportional to the mean of the interpolated luminance there.
struct EnvironmentData : TexelGrid<Rgb> {
  const float* row_cdf = nullptr;      ///< height + 1 numbers.
  const float* column_cdfs = nullptr;  ///< width + 1 numbers for each row.

  RTB_HD const float* column_cdf(int row) const {
    return column_cdfs +
           static_cast<std::size_t>(row) * static_cast<std::size_t>(width + 1);
  }
};

/// A sampled direction. All zero where none could be had.
struct BackgroundSample {
  V3f direction{0};  ///< Unit, away from the scene.
  Rgb radiance{0};   ///< From there.
  float pdf = 0;     ///< Per solid angle.
};

/// Where a direction lies in the image, in texels.
RTB_HD inline V2f EnvironmentPosition(const EnvironmentData& environment,
                                      const V3f& direction) {
  const V3f& d = direction;
  const float longitude = std::atan2(d.x, -d.z);
  const float from_top = std::atan2(std::sqrt(d.x * d.x + d.z * d.z), d.y);
  return {
      (0.5f + longitude / (2 * kPi)) * static_cast<float>(environment.width),
      from_top / kPi * static_cast<float>(environment.height)};
}

/// Radiance from a unit direction, interpolated between texels.
RTB_HD inline Rgb EnvironmentRadiance(const EnvironmentData& environment,
                                      const V3f& direction) {
  const V2f p = EnvironmentPosition(environment, direction);
  return Bilinear(environment, p.x, p.y, EdgeRule::kClamp);
}

/// The solid angle of a texel of row `row`.
RTB_HD inline float TexelSolidAngle(int width, int height, int row) {
  // cos a - cos b = 2 sin((a + b) / 2) sin((b - a) / 2) cancels nothing.
  const float half_step = kPi / 2 / static_cast<float>(height);
  const float middle = half_step * static_cast<float>(2 * row + 1);
  return 4 * kPi / static_cast<float>(width) * SinCosOf(middle).sine *
         SinCosOf(half_step).sine;
}

/// The density of SampleEnvironment per solid angle.
RTB_HD inline float EnvironmentPdf(const EnvironmentData& environment,
                                   const V3f& direction) {
  const V2f p = EnvironmentPosition(environment, direction);
  const int column =
      TexelIndex(static_cast<int>(p.x), environment.width, EdgeRule::kClamp);
  const int row =
      TexelIndex(static_cast<int>(p.y), environment.height, EdgeRule::kClamp);
  return DiscreteProbability(environment.row_cdf, row) *
         DiscreteProbability(environment.column_cdf(row), column) /
         TexelSolidAngle(environment.width, environment.height, row);
}

/// The direction at a longitude (0 = -z) whose height y = cos(angle from +y)
/// is uniform over row `row` of `height`.
RTB_HD inline V3f DirectionInRow(int row, int height, float fraction,
                                 float longitude) {
  // By h = (1 - |cos|) / 2 = sin^2(angle / 2), which is precise at the poles;
  // the lower half of the image mirrors the upper one.
  const bool upper = 2 * row < height;
  const int band = upper ? row : height - 1 - row;
  const float half_step =
      std::numbers::pi_v<float> / 2 / static_cast<float>(height);
  const float s0 = SinCosOf(half_step * static_cast<float>(band)).sine;
  const float s1 = SinCosOf(half_step * static_cast<float>(band + 1)).sine;
  const float h = s0 * s0 + fraction * (s1 * s1 - s0 * s0);
  const float sine = 2 * std::sqrt(h * (1 - h));
  const float cosine = 1 - 2 * h;
  const SineCosine around = SinCosOf(longitude);
  return {sine * around.sine, upper ? cosine : -cosine, -sine * around.cosine};
}

/// A direction for u of the unit square, brighter ones more likely.
RTB_HD inline BackgroundSample SampleEnvironment(
    const EnvironmentData& environment, const V2f& u) {
  const DiscreteSample row =
      SampleDiscrete(environment.row_cdf, environment.height, u.y);
  const DiscreteSample column =
      SampleDiscrete(environment.column_cdf(row.index), environment.width, u.x);
  const float turn = (static_cast<float>(column.index) + column.fraction) /
                         static_cast<float>(environment.width) -
                     0.5f;
  const V3f direction =
      DirectionInRow(row.index, environment.height, row.fraction,
                     turn * 2 * std::numbers::pi_v<float>);
  return {
      direction, EnvironmentRadiance(environment, direction),
      row.probability * column.probability /
          TexelSolidAngle(environment.width, environment.height, row.index)};
}

}  // namespace rtb
