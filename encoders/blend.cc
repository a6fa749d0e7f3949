#include "encoders/blend.h"

#include <algorithm>
#include <cmath>

#include "core/base/check.h"
#include "core/color/oklab.h"
#include "encoders/steps.h"

namespace rtb {
namespace {

/// The comparison is false for NaN.
float Clip(float value) { return value > 0 ? std::min(value, 1.0f) : 0.0f; }

V3d FromLinear(Blend blend, const Rgb& linear) {
  if (blend == Blend::kSrgb) {
    return FromSteps({EncodedSteps(linear.x), EncodedSteps(linear.y),
                      EncodedSteps(linear.z)});
  }
  const V3d clipped(Clip(linear.x), Clip(linear.y), Clip(linear.z));
  return blend == Blend::kLinear ? clipped : LinearToOklab(clipped);
}

}  // namespace

const EncoderParameter& BlendParameter() {
  static const EncoderParameter parameter{
      "blend", "srgb", "srgb|linear|oklab",
      "space in which colors are averaged and compared"};
  return parameter;
}

Result<Blend> ReadBlend(const EncoderParameters& given) {
  RTB_ASSIGN_OR_RETURN(const int choice, ReadChoice(BlendParameter(), given));
  return static_cast<Blend>(choice);
}

void ToBlend(Blend blend, std::span<const Rgb> linear, std::span<V3d> out) {
  RTB_CHECK_EQ(linear.size(), out.size());
  std::ranges::transform(linear, out.begin(), [blend](const Rgb& color) {
    return FromLinear(blend, color);
  });
}

V3d FromRgb8(Blend blend, Rgb8 color) {
  if (blend == Blend::kSrgb) return V3d(color.r, color.g, color.b) / 255;
  return FromLinear(blend, Decode8(color));
}

V3d ToEncoded(Blend blend, const V3d& color) {
  if (blend == Blend::kSrgb) return color;
  const V3d linear = blend == Blend::kLinear ? color : OklabToLinear(color);
  const Rgb single(linear);
  return V3d(SrgbEncode(single.x), SrgbEncode(single.y), SrgbEncode(single.z));
}

Rgb8 ToRgb8(Blend blend, const V3d& color) {
  const V3d encoded = ToEncoded(blend, color);
  return {RoundHalfUp(encoded.x), RoundHalfUp(encoded.y),
          RoundHalfUp(encoded.z)};
}

}  // namespace rtb
