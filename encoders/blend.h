/// @file
/// Blend: the space in which an encoder averages and compares colors.
#pragma once

#include <span>

#include "core/color/srgb.h"
#include "core/math/vec.h"
#include "encoders/parameters.h"
#include "encoders/sample_mask.h"

namespace rtb {

/// `srgb` is the space of the programs and papers that the encoders come
/// from; the others are there to be compared.
enum class Blend { kSrgb, kLinear, kOklab };

/// The parameter `blend=srgb|linear|oklab`, for EncoderInfo.
const EncoderParameter& BlendParameter();

/// The chosen space.
Result<Blend> ReadBlend(const EncoderParameters& given);

/// Linear colors, clipped to [0, 1] (NaN is 0), in the blend space; sRGB values
/// are whole steps (steps.h). Both spans have one length.
void ToBlend(Blend blend, std::span<const Rgb> linear, std::span<V3d> out);

/// A display color in the blend space.
V3d FromRgb8(Blend blend, Rgb8 color);

/// A color of the blend space as sRGB-encoded values in [0, 1], unrounded.
V3d ToEncoded(Blend blend, const V3d& color);

/// The same rounded half up to 8 bits.
Rgb8 ToRgb8(Blend blend, const V3d& color);

}  // namespace rtb
