/// @file
/// TextureTaps: where to look a texture up, so that the mean is that over what
/// a ray sees of it. Host and device.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/base/host_device.h"
#include "core/math/vec.h"
#include "core/shading/ray_cone.h"

namespace rtb {

/// Lookups along the longer axis of a footprint, all at one level of detail:
/// McCormack, Perry, Farkas and Jouppi, "Feline: Fast Elliptical Lines for
/// Anisotropic Texture Mapping", SIGGRAPH 1999; levels as in Williams,
/// "Pyramidal Parametrics", SIGGRAPH 1983.
struct TextureTaps {
  int count = 1;
  V2f first{0, 0};  ///< From (u, v) to the first one.
  V2f step{0, 0};   ///< From one to the next.
  int level = 0;    ///< 0 = the texture itself, each further one half of it.
  float next = 0;   ///< Weight of the level after it, below 1.
};

/// An ellipse by its longer axis and both squared lengths.
struct EllipseAxes {
  V2f direction{1, 0};  ///< Of the longer one, unit.
  float longer = 0;     ///< Squared.
  float shorter = 0;    ///< Squared.
};

/// The principal axes of the ellipse with conjugate diameters a and b: those of
/// the matrix a a' + b b'.
RTB_HD inline EllipseAxes PrincipalAxes(const V2f& a, const V2f& b) {
  const float half_sum = (a.length2() + b.length2()) / 2;
  const float half_difference =
      (a.x * a.x + b.x * b.x - a.y * a.y - b.y * b.y) / 2;
  const float mixed = a.x * a.y + b.x * b.y;
  const float root =
      std::sqrt(half_difference * half_difference + mixed * mixed);
  EllipseAxes axes;
  axes.longer = half_sum + root;
  axes.shorter = std::max(0.0f, half_sum - root);
  const V2f along = half_difference >= 0 ? V2f(half_difference + root, mixed)
                                         : V2f(mixed, root - half_difference);
  if (root > 0) axes.direction = along.normalized();
  return axes;
}

/// The lookups of a footprint, whose mean weighs texels with the variance that
/// a box of the footprint's width has along either axis, w^2 / 12: a level of
/// texels s wide, interpolated, has s^2 / 12 + s^2 / 6, the lookups along the
/// longer axis add the rest. A footprint finer than texels is looked up once.
/// @param texels per unit of u and v.
/// @param levels of the texture.
RTB_HD inline TextureTaps MakeTextureTaps(const UvFootprint& footprint,
                                          const V2f& texels, int levels) {
  TextureTaps taps;
  const EllipseAxes axes =
      PrincipalAxes(footprint.a * texels, footprint.b * texels);
  // Also false for what is no number.
  if (!(axes.longer > 1) || !std::isfinite(axes.longer)) return taps;
  constexpr int kMost = 16;
  const float line = std::sqrt(axes.longer - axes.shorter);
  float size = std::max(std::sqrt(axes.shorter / 3), line / kMost);
  size = std::max(size, 1.0f);
  taps.count = std::clamp(static_cast<int>(std::ceil(line / size)), 1, kMost);
  const auto count = static_cast<float>(taps.count);
  taps.step = axes.direction * (line / count) / texels;
  taps.first = taps.step * ((1 - count) / 2);
  for (; size >= 2 && taps.level < levels - 1; size /= 2) ++taps.level;
  if (taps.level < levels - 1) taps.next = size - 1;
  return taps;
}

/// The mean of lookups around (u, v).
/// @param at called with (level, uv), gives a T.
template <class T, class At>
RTB_HD T MeanOfTaps(const TextureTaps& taps, const V2f& uv, const At& at) {
  T sum(0);
  for (int i = 0; i < taps.count; ++i) {
    const V2f place = uv + taps.first + taps.step * static_cast<float>(i);
    const T value = at(taps.level, place);
    sum += taps.next > 0
               ? value * (1 - taps.next) + at(taps.level + 1, place) * taps.next
               : value;
  }
  return sum / static_cast<float>(taps.count);
}

}  // namespace rtb
