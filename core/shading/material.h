/// @file
/// Materials as plain data for host and device.
#pragma once

#include "core/math/vec.h"
#include "core/shading/bsdf_data.h"
#include "core/shading/checker.h"

namespace rtb {

/// A material: its BSDF, whose color a texture may replace at each point.
struct MaterialData {
  BsdfData bsdf;
  CheckerData checker;
  int texture = -1;    ///< Into ShadingView's textures; -1 = none.
  int bump = -1;       ///< Into ShadingView's bumps; -1 = none.
  Rgb reflectance{0};  ///< Phong.
};

}  // namespace rtb
