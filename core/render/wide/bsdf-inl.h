/// @file
/// bsdf.h on vectors of surface points, for the materials of a WideScene
/// (Highway; for inclusion per target).

// Highway's guard, which flips with each target, in place of #pragma once.
#if defined(RTB_CORE_RENDER_WIDE_BSDF_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTB_CORE_RENDER_WIDE_BSDF_INL_H_
#undef RTB_CORE_RENDER_WIDE_BSDF_INL_H_
#else
#define RTB_CORE_RENDER_WIDE_BSDF_INL_H_
#endif

#include <hwy/highway.h>

#include <cmath>

#include "core/render/wide/ggx-inl.h"
#include "core/render/wide/lanes-inl.h"
#include "core/render/wide/random-inl.h"
#include "core/render/wide/wide_scene.h"
#include "core/shading/bsdf.h"

HWY_BEFORE_NAMESPACE();
namespace rtb {
namespace HWY_NAMESPACE {
namespace wide {

/// Values of a BSDF with the density of their sampling.
struct Densities {
  V3 value;
  F pdf;
};

/// BsdfSample.
struct BsdfSamples {
  V3 wi;
  V3 weight;
  F pdf;
  M delta;
};

/// The lanes whose primitives have a model; none without looking where no
/// primitive has it.
HWY_INLINE M LanesOf(const WideScene& scene, M lanes, I primitive,
                     WideScene::Model model) {
  if (!scene.has[model]) return None();
  return hn::And(
      lanes, LookUp(scene.model, primitive) == Set(static_cast<float>(model)));
}

/// The materials at surface points, and the view of them.
class Bsdfs {
 public:
  /// @param lanes that count. @param wo towards the viewer, local.
  Bsdfs(const WideScene& scene, M lanes, I primitive, const V3& wo)
      : scene_(scene), lanes_(lanes), primitive_(primitive), wo_(wo) {}

  HWY_INLINE M Of(WideScene::Model model) const {
    return LanesOf(scene_, lanes_, primitive_, model);
  }

  /// Light is spread over directions (HasNonDelta).
  HWY_INLINE M Spread() const {
    return hn::Or(Of(WideScene::kLambertian), Of(WideScene::kRough));
  }

  /// EvalBsdf and PdfBsdf; black where not Spread or from below.
  HWY_INLINE Densities Evaluate(const V3& wi) const {
    const F zero = hn::Zero(DF());
    const M above = hn::And(wo_.z > zero, wi.z > zero);
    const M matte = hn::And(Of(WideScene::kLambertian), above);
    const M rough = hn::And(Of(WideScene::kRough), above);
    Densities result{{zero, zero, zero}, zero};
    if (Any(matte)) {
      result.value =
          Select(matte, LookUp(scene_.diffuse, primitive_), result.value);
      result.pdf = hn::IfThenElseZero(matte, wi.z / Divisor(kPi));
    }
    if (Any(rough)) {
      const Lobe lobe(scene_, rough, primitive_, wo_);
      result.value = Select(rough, lobe.Value(wi), result.value);
      result.pdf = Select(rough, lobe.Pdf(wi), result.pdf);
    }
    return result;
  }

  /// SampleBsdf.
  HWY_INLINE BsdfSamples Draw(const SobolPoint& u) const {
    const F zero = hn::Zero(DF());
    const V3 black{zero, zero, zero};
    BsdfSamples samples{Mirrored(), black, zero, None()};
    const M spread = hn::And(Spread(), wo_.z > zero);
    if (Any(spread)) DrawSpread(u, spread, &samples);
    DrawMirrors(&samples);
    const M glass = Of(WideScene::kGlass);
    if (Any(glass)) DrawGlass(u.z(), glass, &samples);
    return samples;
  }

 private:
  HWY_INLINE V3 Mirrored() const {
    return {hn::Neg(wo_.x), hn::Neg(wo_.y), wo_.z};
  }

  /// SampleOf the directions of the Lambertian and the GGX lobe.
  HWY_INLINE void DrawSpread(const SobolPoint& u, M spread,
                             BsdfSamples* samples) const {
    const F ux = u.x(), uy = u.y();
    const M rough = hn::And(Of(WideScene::kRough), spread);
    samples->wi = Select(spread, Cosine(ux, uy), samples->wi);
    if (Any(rough)) {
      const Lobe lobe(scene_, rough, primitive_, wo_);
      samples->wi = Select(rough, lobe.Direction(ux, uy), samples->wi);
    }
    const Densities f = Evaluate(samples->wi);
    const M found = hn::And(spread, f.pdf > hn::Zero(DF()));
    samples->weight =
        Select(found, f.value * (samples->wi.z / f.pdf), samples->weight);
    samples->pdf = hn::IfThenElseZero(found, f.pdf);
  }

  /// SampleCosine.
  static HWY_INLINE V3 Cosine(F ux, F uy) {
    const F radius = hn::Sqrt(ux);
    const SinCos phi = SinCosOf(Set(2 * kPi) * uy);
    return {radius * phi.cosine, radius * phi.sine, hn::Sqrt(Set(1) - ux)};
  }

  HWY_INLINE void DrawMirrors(BsdfSamples* samples) const {
    const M front = wo_.z > hn::Zero(DF());
    const M mirror = hn::And(Of(WideScene::kMirror), front);
    const M smooth = hn::And(Of(WideScene::kSmooth), front);
    const M both = hn::Or(mirror, smooth);
    if (!Any(both)) return;
    const V3 color = LookUp(scene_.color, primitive_);
    samples->weight = Select(both, Select(smooth, Schlick(color, wo_.z), color),
                             samples->weight);
    samples->delta = hn::Or(samples->delta, both);
  }

  /// SampleDielectric.
  HWY_INLINE void DrawGlass(F u, M glass, BsdfSamples* samples) const {
    const F one = Set(1), zero = hn::Zero(DF());
    const M outside = wo_.z > zero;
    const F eta = Select(outside, LookUp(scene_.outside, primitive_),
                         LookUp(scene_.inside, primitive_));
    const F cosine = Select(outside, wo_.z, hn::Neg(wo_.z));
    const F sin2 = eta * eta * (one - cosine * cosine);
    const F cos_t = hn::Sqrt(hn::Max(one - sin2, zero));
    const F s = (eta * cosine - cos_t) / (eta * cosine + cos_t);
    const F p = (cosine - eta * cos_t) / (cosine + eta * cos_t);
    const F partial = (s * s + p * p) / Set(2);
    const M reflects = hn::Or(u < partial, sin2 >= one);
    const F turned = eta * cosine - cos_t;
    const V3 refracted = Normalized(
        {hn::Neg(wo_.x) * eta, hn::Neg(wo_.y) * eta,
         hn::Neg(wo_.z) * eta + Select(outside, turned, hn::Neg(turned))});
    const M passes = hn::AndNot(reflects, glass);
    const V3 white{one, one, one};
    samples->wi = Select(passes, refracted, samples->wi);
    samples->weight = Select(passes, LookUp(scene_.color, primitive_),
                             Select(glass, white, samples->weight));
    samples->delta = hn::Or(samples->delta, glass);
  }

  const WideScene& scene_;
  M lanes_;
  I primitive_;
  V3 wo_;
};

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace wide
}  // namespace HWY_NAMESPACE
}  // namespace rtb
HWY_AFTER_NAMESPACE();

#endif  // RTB_CORE_RENDER_WIDE_BSDF_INL_H_
