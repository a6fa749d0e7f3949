/// @file
/// WideScene: a scene of few spheres, disks and planes with simple materials
/// under a sky, laid out for vectors of paths.
#pragma once

#include <optional>

#include "core/accel/geometry.h"
#include "core/shading/shading_scene.h"

namespace rtb {

/// One column for each primitive: planes, then spheres, then disks. Numbers
/// that the scalar code derives from a primitive or material alone are here
/// once for all.
struct WideScene {
  /// Primitives at most: a vector holds one entry of each.
  static constexpr int kMost = 16;
  using Row = float[kMost];
  using Rows = Row[3];

  int planes = 0;  ///< Are primitives [0, planes).
  int spheres = 0;
  int disks = 0;
  int count() const { return planes + spheres + disks; }

  /// What materials a primitive may have.
  enum Model { kLambertian, kMirror, kRough, kSmooth, kGlass };
  bool has[5] = {};  ///< Some primitive has this model.
  alignas(64) Row model = {};

  alignas(64) Rows center = {};       ///< A plane's point.
  alignas(64) Rows normal = {};       ///< Of planes and disks.
  alignas(64) Rows to_unit[3] = {};   ///< The images of x, y and z.
  alignas(64) Rows to_world[3] = {};  ///< Likewise.
  alignas(64) Row scale = {};  ///< SurfacePoint's; of planes their points'.

  alignas(64) Rows color = {};
  alignas(64) Rows diffuse = {};  ///< Color / pi.
  alignas(64) Row inside = {};    ///< Index inside relative to outside,
  alignas(64) Row outside = {};   ///< and its inverse.

  alignas(64) Row alpha = {};
  alignas(64) Rows compensation = {};  ///< F times the further share,
  alignas(64) Row further = {};        ///< whose largest component this is.
  alignas(64) Row mean_loss = {};      ///< pi times the average loss.
  alignas(64) Row log_range = {};      ///< log(1 + 1 / alpha).

  BackgroundData sky;
  float sky_chance = 1;  ///< That next-event estimation takes the sky.
  GgxEnergyView energy;
};

/// The scene for vectors; nothing where it has other shapes, materials or
/// lights than these, textures, or more than kMost primitives.
std::optional<WideScene> MakeWideScene(const Geometry& geometry,
                                       const ShadingView& shading);

}  // namespace rtb
