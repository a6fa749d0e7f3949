/// @file
/// The GGX lobe of rough metal (bsdf_glossy.h, microfacet.h) on vectors
/// (Highway; for inclusion per target).

// Highway's guard, which flips with each target, in place of #pragma once.
#if defined(RTB_CORE_RENDER_WIDE_GGX_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTB_CORE_RENDER_WIDE_GGX_INL_H_
#undef RTB_CORE_RENDER_WIDE_GGX_INL_H_
#else
#define RTB_CORE_RENDER_WIDE_GGX_INL_H_
#endif

#include <hwy/highway.h>

#include <cmath>

#include "core/math/constants.h"
#include "core/render/wide/lanes-inl.h"
#include "core/render/wide/random-inl.h"
#include "core/render/wide/wide_scene.h"
#include "core/shading/bsdf_glossy.h"

HWY_BEFORE_NAMESPACE();
namespace rtb {
namespace HWY_NAMESPACE {
namespace wide {

/// FresnelSchlick.
HWY_INLINE V3 Schlick(const V3& f0, F cosine) {
  const F m = Set(1) - cosine;
  const F m2 = m * m;
  return f0 + (V3{Set(1), Set(1), Set(1)} - f0) * (m2 * m2 * m);
}

/// Replaces the lanes of a mask by change(lane's number): for what is rare,
/// or has no vector form.
template <class Change>
HWY_INLINE void ForEachLane(M mask, const Change& change) {
  alignas(64) float chosen[hn::MaxLanes(DF())];
  hn::Store(hn::IfThenElseZero(mask, Set(1)), DF(), chosen);
  for (std::size_t lane = 0; lane < hn::Lanes(DF()); ++lane) {
    if (chosen[lane] != 0) change(lane);
  }
}

/// std::log1p of some lanes.
HWY_INLINE F Log1p(M lanes, F x) {
  alignas(64) float values[hn::MaxLanes(DF())];
  hn::Store(x, DF(), values);
  ForEachLane(lanes, [&](std::size_t lane) {
    values[lane] = std::log1p(values[lane]);
  });
  return hn::Load(DF(), values);
}

/// A rough metal as seen from some lanes' viewers.
class Lobe {
 public:
  Lobe(const WideScene& scene, M lanes, I primitive, const V3& wo)
      : scene_(scene), lanes_(lanes), primitive_(primitive), wo_(wo) {
    alpha_ = LookUp(scene.alpha, primitive);
    stretched_ = StretchedLength(wo);
    loss_ = Loss(wo.z);
    // SingleChance.
    const F kept = Set(1) - loss_;
    single_ = kept / (kept + loss_ * LookUp(scene.further, primitive));
  }

  /// EvalGlossy.
  HWY_INLINE V3 Value(const V3& wi) const {
    const V3 h = Normalized(wo_ + wi);
    const F visibility =
        Set(0.5f) / (wi.z * stretched_ + wo_.z * StretchedLength(wi));
    const V3 once = Schlick(LookUp(scene_.color, primitive_), Dot(wo_, h)) *
                    (Distribution(h) * visibility);
    const F loss = loss_ * Loss(wi.z) / LookUp(scene_.mean_loss, primitive_);
    return once + LookUp(scene_.compensation, primitive_) * loss;
  }

  /// PdfGlossy.
  HWY_INLINE F Pdf(const V3& wi) const {
    const V3 h = Normalized(wo_ + wi);
    const F reflection = Distribution(h) / (Set(2) * (wo_.z + stretched_));
    const F range = LookUp(scene_.log_range, primitive_);
    const F compensation = Log1p(lanes_, wi.z / alpha_) /
                           (range * range * Set(kPi) * (wi.z + alpha_));
    return single_ * reflection + (Set(1) - single_) * compensation;
  }

  /// GlossyDirection.
  HWY_INLINE V3 Direction(F ux, F uy) const {
    const V3 h = VisibleNormal(ux / single_, uy);
    V3 wi = Normalized(h * (Set(2) * Dot(wo_, h)) - wo_);
    const M other = hn::And(lanes_, ux >= single_);
    if (Any(other)) Compensate(other, ux, uy, &wi);
    return wi;
  }

 private:
  HWY_INLINE F Distribution(const V3& h) const {
    const Divisor alpha(alpha_);
    const F x = h.x / alpha;
    const F y = h.y / alpha;
    const F t = x * x + y * y + h.z * h.z;
    return Set(1) / (Set(kPi) * (alpha_ * t) * (alpha_ * t));
  }

  HWY_INLINE F StretchedLength(const V3& w) const {
    return hn::Sqrt(w.z * w.z + alpha_ * alpha_ * (w.x * w.x + w.y * w.y));
  }

  /// GgxLoss.
  HWY_INLINE F Loss(F cosine) const {
    const F one = Set(1);
    const F y = hn::Sqrt(cosine * (one + alpha_) / (cosine + alpha_));
    const F column = Select(y < one, y, one) * Set(kGgxCosines - 1);
    const F row = hn::Sqrt(alpha_) * Set(kGgxRoughnesses - 1);
    const I c = CellOf(column, kGgxCosines - 2);
    const I r = CellOf(row, kGgxRoughnesses - 2);
    const F s = column - hn::ConvertTo(DF(), c);
    const F t = row - hn::ConvertTo(DF(), r);
    const I low = hn::IfThenElseZero(hn::RebindMask(DI(), lanes_),
                                     r * hn::Set(DI(), kGgxCosines) + c);
    const I high = low + hn::Set(DI(), kGgxCosines);
    const F root = (one - t) * Between(low, s) + t * Between(high, s);
    return root * root;
  }
  static HWY_INLINE I CellOf(F position, int last) {
    return hn::Min(hn::ConvertTo(DI(), position), hn::Set(DI(), last));
  }
  HWY_INLINE F Between(I i, F s) const {
    const float* table = scene_.energy.root_loss;
    return (Set(1) - s) * hn::GatherIndex(DF(), table, i) +
           s * hn::GatherIndex(DF(), table + 1, i);
  }

  /// SampleVisibleNormal.
  HWY_INLINE V3 VisibleNormal(F ux, F uy) const {
    const F one = Set(1), zero = hn::Zero(DF());
    const V3 stretched = Normalized({alpha_ * wo_.x, alpha_ * wo_.y, wo_.z});
    const F z = (one - uy) * (one + stretched.z) - stretched.z;
    const F z2 = z * z;
    const F radius = hn::Sqrt(Select(z2 < one, one - z2, zero));
    const SinCos phi = SinCosOf(Set(2 * kPi) * ux);
    const V3 sum = V3{radius * phi.cosine, radius * phi.sine, z} + stretched;
    return Normalized({alpha_ * sum.x, alpha_ * sum.y, sum.z});
  }

  /// SampleCompensation for the few that take it.
  HWY_INLINE void Compensate(M lanes, F ux, F uy, V3* wi) const {
    alignas(64) float x[hn::MaxLanes(DF())], y[hn::MaxLanes(DF())],
        z[hn::MaxLanes(DF())], alpha[hn::MaxLanes(DF())];
    hn::Store(uy, DF(), x);
    hn::Store((ux - single_) / (Set(1) - single_), DF(), y);
    hn::Store(wi->z, DF(), z);
    hn::Store(alpha_, DF(), alpha);
    ForEachLane(lanes, [&](std::size_t i) {
      const V3f w = SampleCompensation(alpha[i], V2f(x[i], y[i]));
      x[i] = w.x;
      y[i] = w.y;
      z[i] = w.z;
    });
    const V3 found{hn::Load(DF(), x), hn::Load(DF(), y), hn::Load(DF(), z)};
    *wi = Select(lanes, found, *wi);
  }

  const WideScene& scene_;
  M lanes_;
  I primitive_;
  V3 wo_;
  F alpha_, stretched_, loss_, single_;
};

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace wide
}  // namespace HWY_NAMESPACE
}  // namespace rtb
HWY_AFTER_NAMESPACE();

#endif  // RTB_CORE_RENDER_WIDE_GGX_INL_H_
