/// @file
/// The kinds of materials.
#pragma once

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

}  // namespace rtb
