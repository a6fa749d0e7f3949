/// @file
/// Vectors of a survey, each lane of which is a cell, and their place in
/// memory. For inclusion per target (Highway).

// Highway's guard, which flips with each target, in place of #pragma once.
#if defined(RTB_ENCODERS_FIT_SURVEY_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTB_ENCODERS_FIT_SURVEY_LANES_INL_H_
#undef RTB_ENCODERS_FIT_SURVEY_LANES_INL_H_
#else
#define RTB_ENCODERS_FIT_SURVEY_LANES_INL_H_
#endif

#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>
#include <vector>

#include "encoders/fit/survey.h"

HWY_BEFORE_NAMESPACE();
namespace rtb {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using SurveyFloats = hn::CappedTag<float, SurveyBatch::stride>;
using SurveyInts = hn::RebindToSigned<SurveyFloats>;
using F = hn::Vec<SurveyFloats>;
using I = hn::Vec<SurveyInts>;

constexpr std::size_t kStride = SurveyBatch::stride;
constexpr std::size_t kChannels = 3;

HWY_INLINE I LoadInts(const std::vector<std::int32_t>& values, std::size_t i) {
  return hn::LoadU(SurveyInts(), values.data() + i * kStride);
}
HWY_INLINE void Put(I v, std::vector<std::int32_t>& values, std::size_t i) {
  hn::StoreU(v, SurveyInts(), values.data() + i * kStride);
}
HWY_INLINE F LoadFloats(const std::vector<float>& values, std::size_t i) {
  return hn::LoadU(SurveyFloats(), values.data() + i * kStride);
}
HWY_INLINE void Put(F v, std::vector<float>& values, std::size_t i) {
  hn::StoreU(v, SurveyFloats(), values.data() + i * kStride);
}
HWY_INLINE F ToFloats(I v) { return hn::ConvertTo(SurveyFloats(), v); }
HWY_INLINE F Same(float v) { return hn::Set(SurveyFloats(), v); }
HWY_INLINE I Same(int v) { return hn::Set(SurveyInts(), v); }

/// One vector for each channel.
template <class V>
struct Channels {
  V r, g, b;
};

HWY_INLINE Channels<I> LoadTriple(const std::vector<std::int32_t>& values,
                                  std::size_t i) {
  return {LoadInts(values, kChannels * i), LoadInts(values, kChannels * i + 1),
          LoadInts(values, kChannels * i + 2)};
}
HWY_INLINE void PutTriple(const Channels<I>& v,
                          std::vector<std::int32_t>& values, std::size_t i) {
  Put(v.r, values, kChannels * i);
  Put(v.g, values, kChannels * i + 1);
  Put(v.b, values, kChannels * i + 2);
}
HWY_INLINE Channels<I> operator+(const Channels<I>& a, const Channels<I>& b) {
  return {hn::Add(a.r, b.r), hn::Add(a.g, b.g), hn::Add(a.b, b.b)};
}
HWY_INLINE Channels<I> operator-(const Channels<I>& a, const Channels<I>& b) {
  return {hn::Sub(a.r, b.r), hn::Sub(a.g, b.g), hn::Sub(a.b, b.b)};
}
HWY_INLINE Channels<I> operator*(const Channels<I>& a, int b) {
  return {hn::Mul(a.r, Same(b)), hn::Mul(a.g, Same(b)), hn::Mul(a.b, Same(b))};
}
HWY_INLINE Channels<I> SameInAll(int v) { return {Same(v), Same(v), Same(v)}; }

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace rtb
HWY_AFTER_NAMESPACE();

#endif  // RTB_ENCODERS_FIT_SURVEY_LANES_INL_H_
