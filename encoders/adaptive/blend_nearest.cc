#include "encoders/adaptive/blend_nearest.h"

#include <algorithm>

#include "core/base/check.h"
#include "encoders/adaptive/samples.h"

// This file is compiled once for each target.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "encoders/adaptive/blend_nearest.cc"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace rtb {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using PlaceFloats = hn::CappedTag<float, BlendPlaces::kRoom>;
using PlaceInts = hn::RebindToSigned<PlaceFloats>;
using F = hn::Vec<PlaceFloats>;
using I = hn::Vec<PlaceInts>;

/// Keeps weights finite: about the squared distance within a sub-pixel.
constexpr float kWithinPixel = 0.25f;

/// Samples nearer to each other than this tell how a sub-pixel is divided.
constexpr float kPixelReach = 3;

HWY_INLINE F Same(float v) { return hn::Set(PlaceFloats(), v); }
HWY_INLINE I Same(int v) { return hn::Set(PlaceInts(), v); }

/// One vector of places.
class PlaceBlender {
 public:
  HWY_INLINE explicit PlaceBlender(const NearSamples& near)
      : near_(near),
        first_(Same(0.0f)),
        second_(first_),
        third_(first_),
        encoded_{first_, first_, first_},
        linear_(encoded_),
        sum_(first_),
        far_(first_) {}

  HWY_INLINE void Blend(F x, F y, std::size_t at, BlendedPlaces& out) {
    Find(x, y);
    Add(first_);
    if (near_.size() > 1) Add(second_);
    if (near_.size() > 2) Add(third_);
    Store(encoded_, out.encoded[at]);
    Store(linear_, out.linear[at]);
    const F far = hn::Div(far_, Same(kPixelReach * kPixelReach));
    hn::StoreU(hn::Div(Same(1.0f), hn::Add(Same(1.0f), far)), PlaceFloats(),
               &out.share[at]);
  }

 private:
  /// Three channels in Rgb's order.
  struct Color {
    F r, g, b;
  };

  /// The keys of the nearest samples. A key is a squared distance with the
  /// sample's index in its lowest bits: a positive float, so that comparing two
  /// of them compares the distances.
  HWY_INLINE void Find(F x, F y) {
    const I mask = Same(~static_cast<int>(kMostNear));
    F a = Same(3e38f), b = a, c = a;
    for (std::size_t n = 0; n < near_.size(); ++n) {
      const F dx = hn::Sub(Same(near_.x[n]), x);
      const F dy = hn::Sub(Same(near_.y[n]), y);
      const F distance2 = hn::Add(hn::Add(hn::Mul(dx, dx), hn::Mul(dy, dy)),
                                  Same(kWithinPixel));
      const I bits = hn::Or(hn::And(hn::BitCast(PlaceInts(), distance2), mask),
                            Same(static_cast<int>(n)));
      const F key = hn::BitCast(PlaceFloats(), bits);
      const F not_first = hn::Max(a, key);
      a = hn::Min(a, key);
      const F not_second = hn::Max(b, not_first);
      b = hn::Min(b, not_first);
      c = hn::Min(c, not_second);
    }
    first_ = a;
    second_ = b;
    third_ = c;
  }

  /// Adds the sample of a key; the means are those up to here.
  HWY_INLINE void Add(F key) {
    const F weight = hn::Div(Same(1.0f), hn::Mul(key, key));
    const I index = hn::And(hn::BitCast(PlaceInts(), key),
                            Same(static_cast<int>(kMostNear)));
    const I at = hn::Add(hn::Add(index, index), index);
    Weigh(&near_.encoded[0].x, at, weight, encoded_);
    Weigh(&near_.linear[0].x, at, weight, linear_);
    sum_ = hn::Add(sum_, weight);
    far_ = key;
  }

  static HWY_INLINE void Weigh(const float* colors, I at, F weight,
                               Color& color) {
    const PlaceFloats d;
    color.r = hn::Add(color.r, hn::Mul(hn::GatherIndex(d, colors, at), weight));
    color.g =
        hn::Add(color.g, hn::Mul(hn::GatherIndex(d, colors + 1, at), weight));
    color.b =
        hn::Add(color.b, hn::Mul(hn::GatherIndex(d, colors + 2, at), weight));
  }

  HWY_INLINE void Store(const Color& color, Rgb& out) const {
    hn::StoreInterleaved3(hn::Div(color.r, sum_), hn::Div(color.g, sum_),
                          hn::Div(color.b, sum_), PlaceFloats(), &out.x);
  }

  const NearSamples& near_;
  F first_, second_, third_;  ///< Keys.
  Color encoded_, linear_;
  F sum_;
  F far_;
};

void BlendAll(const NearSamples& near, const BlendPlaces& places,
              BlendedPlaces& out) {
  const PlaceFloats d;
  for (std::size_t i = 0; i < places.x.size(); i += hn::Lanes(d)) {
    PlaceBlender(near).Blend(hn::LoadU(d, &places.x[i]),
                             hn::LoadU(d, &places.y[i]), i, out);
  }
}

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace rtb
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rtb {

HWY_EXPORT(BlendAll);

void NearSamples::Clear() {
  x.clear();
  y.clear();
  encoded.clear();
  linear.clear();
}

void NearSamples::Add(const V2f& at, const Rgb& encoded_color,
                      const Rgb& linear_color) {
  x.push_back(at.x);
  y.push_back(at.y);
  encoded.push_back(encoded_color);
  linear.push_back(linear_color);
}

bool NearSamples::Alike() const {
  constexpr float kUnseen = 2.0f / 255;
  Rgb low = encoded[0];
  Rgb high = low;
  for (const Rgb& color : encoded) {
    for (int c = 0; c < 3; ++c) {
      low[c] = std::min(low[c], color[c]);
      high[c] = std::max(high[c], color[c]);
    }
  }
  const Rgb range = high - low;
  return std::max({range.x, range.y, range.z}) < kUnseen;
}

bool NearSamples::Overexposed() const {
  return std::ranges::any_of(linear, [](const Rgb& light) {
    return std::min({light.x, light.y, light.z}) >= 1;
  });
}

BlendPlaces::BlendPlaces(int width, int height, float cell_width) {
  for (int j = 0; j < height; ++j) {
    for (int i = 0; i < width; ++i) {
      x.push_back((static_cast<float>(i) + 0.5f) * cell_width /
                  static_cast<float>(width));
      y.push_back((static_cast<float>(j) + 0.5f) * kCellHeight /
                  static_cast<float>(height));
    }
  }
  const std::size_t room = (x.size() + kRoom - 1) / kRoom * kRoom;
  x.resize(room, x.back());
  y.resize(room, y.back());
}

BlendedPlaces::BlendedPlaces(const BlendPlaces& places)
    : encoded(places.x.size(), Rgb(0)),
      linear(places.x.size(), Rgb(0)),
      share(places.x.size()) {}

void BlendNearest(const NearSamples& near, const BlendPlaces& places,
                  BlendedPlaces& out) {
  RTB_CHECK(near.size() >= 1 && near.size() <= kMostNear);
  RTB_CHECK_EQ(places.x.size(), out.share.size());
  HWY_DYNAMIC_DISPATCH(BlendAll)(near, places, out);
}

}  // namespace rtb
#endif  // HWY_ONCE
