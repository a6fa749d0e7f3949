/// @file
/// The radiance that rays bring from beyond the scene, and its sampling.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/host_device.h"
#include "core/color/luminance.h"
#include "core/math/sin_cos.h"
#include "core/math/vec.h"
#include "core/shading/environment.h"

namespace rtb {

/// An image where `image` has texels; else the gradient
/// bottom + (top - bottom) * 0.5 * (y + 1). A constant has both equal.
struct BackgroundData {
  Rgb bottom{0};
  Rgb top{0};
  EnvironmentData image{};
};

/// Radiance from a unit direction.
RTB_HD inline Rgb BackgroundRadiance(const BackgroundData& background,
                                     const V3f& direction) {
  if (background.image.texels != nullptr) {
    return EnvironmentRadiance(background.image, direction);
  }
  return background.bottom +
         (background.top - background.bottom) * (0.5f * (direction.y + 1));
}

/// The density of SampleGradient, per solid angle: in proportion to luminance,
/// which is linear in y; uniform where all is black.
RTB_HD inline float GradientPdf(const BackgroundData& background, float y) {
  constexpr float kUniform = 1 / (4 * std::numbers::pi_v<float>);
  const float bottom = Luminance(background.bottom);
  const float mean = (bottom + Luminance(background.top)) / 2;
  if (!(mean > 0)) return kUniform;
  const float here =
      bottom + (Luminance(background.top) - bottom) * (0.5f * (y + 1));
  return kUniform * here / mean;
}

/// A direction for u of the unit square, by the inverse of the distribution of
/// y, which is quadratic.
RTB_HD inline BackgroundSample SampleGradient(const BackgroundData& background,
                                              const V2f& u) {
  const float bottom = Luminance(background.bottom);
  const float top = Luminance(background.top);
  const float root = std::sqrt((1 - u.y) * bottom * bottom + u.y * top * top);
  // t with (bottom t + (top - bottom) t^2 / 2) / mean = u.
  const float t =
      bottom + root > 0 ? u.y * (bottom + top) / (bottom + root) : u.y;
  const float y = 2 * std::min(t, 1.0f) - 1;
  const float sine = std::sqrt(std::max(0.0f, (1 - y) * (1 + y)));
  const SineCosine longitude = SinCosOf(2 * std::numbers::pi_v<float> * u.x);
  const V3f direction(sine * longitude.cosine, y, sine * longitude.sine);
  const float pdf = GradientPdf(background, y);
  if (!(pdf > 0)) return {};
  return {direction, BackgroundRadiance(background, direction), pdf};
}

/// A direction chosen in proportion to the radiance's luminance, exactly for
/// gradients and texel by texel for images.
/// @param u of the unit square.
RTB_HD inline BackgroundSample SampleBackground(
    const BackgroundData& background, const V2f& u) {
  return background.image.texels != nullptr
             ? SampleEnvironment(background.image, u)
             : SampleGradient(background, u);
}

/// The density per solid angle with which SampleBackground chooses a unit
/// direction.
RTB_HD inline float BackgroundPdf(const BackgroundData& background,
                                  const V3f& direction) {
  return background.image.texels != nullptr
             ? EnvironmentPdf(background.image, direction)
             : GradientPdf(background, direction.y);
}

}  // namespace rtb
