/// @file
/// Axis-aligned boxes around the primitives of a FlatScene.
#pragma once

#include <limits>

#include "core/scene/flat_scene.h"

namespace rtb {

/// A box that grows; empty at first.
struct Bounds {
  V3d min{std::numeric_limits<double>::infinity()};
  V3d max{-std::numeric_limits<double>::infinity()};

  void Add(const V3d& point);
  void Add(const Bounds& other);
  /// Length from corner to corner; 0 when empty.
  double Diagonal() const;
};

/// @name The tightest box of a primitive in world space.
/// @{
Bounds BoundsOf(const FlatSphere& sphere);
Bounds BoundsOf(const FlatDisk& disk);
Bounds BoundsOf(const FlatTriangle& triangle);
Bounds BoundsOf(const Scene& scene, const FlatScene& flat, const FlatMesh& use);
/// @}

/// Whether the insides of two boxes meet.
bool Overlap(const Bounds& a, const Bounds& b);

}  // namespace rtb
