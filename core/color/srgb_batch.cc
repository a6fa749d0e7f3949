// The sRGB transfer of many values at once, on the widest vectors that the
// processor has (Highway chooses at run time).
#include <algorithm>

#include "core/base/check.h"
#include "core/color/srgb.h"

// This file is compiled once for each target.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/color/srgb_batch.cc"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/color/srgb-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rtb {
namespace HWY_NAMESPACE {

void EncodeCodes(const float* linear, std::size_t count, std::uint8_t* codes) {
  const hn::ScalableTag<float> d;
  const hn::Rebind<std::uint8_t, decltype(d)> d8;
  const std::size_t lanes = hn::Lanes(d);
  const SrgbCodeTable& table = SrgbCodes();
  std::size_t i = 0;
  for (; i + lanes <= count; i += lanes) {
    const auto code = SrgbCodesOf(d, hn::LoadU(d, linear + i), table);
    hn::StoreU(hn::DemoteTo(d8, code), d8, codes + i);
  }
  for (; i < count; ++i) codes[i] = SrgbEncode8(linear[i]);
}

void EncodeCurve(const float* linear, std::size_t count, float* encoded) {
  const hn::ScalableTag<float> d;
  const std::size_t lanes = hn::Lanes(d);
  const SrgbCurveTable& table = SrgbCurve();
  std::size_t i = 0;
  for (; i + lanes <= count; i += lanes) {
    hn::StoreU(SrgbCurveOf(d, hn::LoadU(d, linear + i), table), d, encoded + i);
  }
  for (; i < count; ++i) encoded[i] = SrgbEncode(linear[i]);
}

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace rtb
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rtb {

HWY_EXPORT(EncodeCodes);
HWY_EXPORT(EncodeCurve);

// Colors are read and written as the components that they consist of.
static_assert(sizeof(Rgb) == 3 * sizeof(float) && sizeof(Rgb8) == 3);

void Encode8(std::span<const Rgb> linear, std::span<Rgb8> codes) {
  RTB_CHECK_EQ(linear.size(), codes.size());
  if (linear.empty()) return;
  HWY_DYNAMIC_DISPATCH(EncodeCodes)
  (&linear[0].x, 3 * linear.size(), &codes[0].r);
}

void SrgbEncode(std::span<const float> linear, std::span<float> encoded) {
  RTB_CHECK_EQ(linear.size(), encoded.size());
  HWY_DYNAMIC_DISPATCH(EncodeCurve)
  (linear.data(), linear.size(), encoded.data());
}

void SrgbEncode(std::span<const Rgb> linear, std::span<Rgb> encoded) {
  RTB_CHECK_EQ(linear.size(), encoded.size());
  if (linear.empty()) return;
  HWY_DYNAMIC_DISPATCH(EncodeCurve)
  (&linear[0].x, 3 * linear.size(), &encoded[0].x);
}

}  // namespace rtb
#endif  // HWY_ONCE
