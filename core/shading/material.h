/// @file
/// Materials as plain data for host and device, and the checker texture.
#pragma once

#include <cmath>

#include "core/base/host_device.h"
#include "core/math/vec.h"

namespace rtb {

/// What a surface does with light.
enum class SurfaceModel {
  kLambertian,
  kMirror,
  kMetal,
  kDielectric,
  kPlastic,
  kPhong,
  kEmissive
};

/// Checker in object space; size 0 = none.
struct CheckerData {
  Rgb a{0};
  Rgb b{0};
  float size = 0;
};

/// A material. `color` is albedo, reflectance, tint or radiance by model.
struct MaterialData {
  SurfaceModel model = SurfaceModel::kLambertian;
  Rgb color{0.5f};
  float ior = 1.5f;
  CheckerData checker;
};

/// The checker's color at a point of object space, moved by size/1000 along
/// the unit geometric normal so that a face on a cell border never flickers.
RTB_HD inline Rgb CheckerColor(const CheckerData& checker, const V3f& position,
                               const V3f& normal) {
  const V3f p = position / checker.size + normal * 0.001f;
  // The parity of a sum of floors, each reduced first: no overflow, far out.
  const float sum = std::fmod(std::floor(p.x), 2.0f) +
                    std::fmod(std::floor(p.y), 2.0f) +
                    std::fmod(std::floor(p.z), 2.0f);
  return std::fmod(sum, 2.0f) == 0 ? checker.a : checker.b;
}

}  // namespace rtb
