/// @file
/// A gradient sky (background.h) on vectors of directions (Highway; for
/// inclusion per target).

// Highway's guard, which flips with each target, in place of #pragma once.
#if defined(RTB_CORE_RENDER_WIDE_SKY_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTB_CORE_RENDER_WIDE_SKY_INL_H_
#undef RTB_CORE_RENDER_WIDE_SKY_INL_H_
#else
#define RTB_CORE_RENDER_WIDE_SKY_INL_H_
#endif

#include <hwy/highway.h>

#include <numbers>

#include "core/color/luminance.h"
#include "core/render/wide/lanes-inl.h"
#include "core/render/wide/random-inl.h"
#include "core/render/wide/wide_scene.h"

HWY_BEFORE_NAMESPACE();
namespace rtb {
namespace HWY_NAMESPACE {
namespace wide {

/// BackgroundSample.
struct SkySamples {
  V3 direction;
  V3 radiance;
  F pdf;
};

/// The sky's radiance and its sampling.
class Sky {
 public:
  explicit Sky(const WideScene& scene)
      : color_(scene.sky.bottom),
        rise_(scene.sky.top - scene.sky.bottom),
        bottom_(Luminance(scene.sky.bottom)),
        top_(Luminance(scene.sky.top)) {}

  /// BackgroundRadiance.
  HWY_INLINE V3 Radiance(F y) const {
    return Set(color_) + Set(rise_) * HeightOf(y);
  }

  /// GradientPdf.
  HWY_INLINE F Pdf(F y) const {
    const float mean = (bottom_ + top_) / 2;
    if (!(mean > 0)) return Set(kUniform);
    const F here = Set(bottom_) + Set(top_ - bottom_) * HeightOf(y);
    return Set(kUniform) * here / Divisor(mean);
  }

  /// SampleGradient.
  HWY_INLINE SkySamples Draw(F ux, F uy) const {
    const F one = Set(1), zero = hn::Zero(DF());
    const F bottom = Set(bottom_), top = Set(top_);
    const F root = hn::Sqrt((one - uy) * bottom * bottom + uy * top * top);
    const F sum = bottom + root;
    const F t = Select(sum > zero, uy * (bottom + top) / sum, uy);
    const F y = Set(2) * hn::Min(t, one) - one;
    const F sine = hn::Sqrt(hn::Max(zero, (one - y) * (one + y)));
    const SinCos longitude = SinCosOf(Set(2 * std::numbers::pi_v<float>) * ux);
    return {{sine * longitude.cosine, y, sine * longitude.sine},
            Radiance(y),
            Pdf(y)};
  }

 private:
  static constexpr float kUniform = 1 / (4 * std::numbers::pi_v<float>);

  static HWY_INLINE F HeightOf(F y) { return Set(0.5f) * (y + Set(1)); }

  Rgb color_, rise_;
  float bottom_, top_;
};

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace wide
}  // namespace HWY_NAMESPACE
}  // namespace rtb
HWY_AFTER_NAMESPACE();

#endif  // RTB_CORE_RENDER_WIDE_SKY_INL_H_
