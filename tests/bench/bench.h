/// @file
/// The program's groups of benchmarks; each registers its own.
#pragma once

#include <memory>
#include <string>

#include "core/base/result.h"
#include "core/render/backend.h"
#include "core/scene/scene.h"

namespace rtb {

/// A scene of the repository, ready to render on the default backend.
struct BenchScene {
  std::unique_ptr<Scene> scene;
  std::unique_ptr<Backend> backend;
};

/// Loads `scenes/<name>.yaml`.
Result<BenchScene> LoadBenchScene(const std::string& name);

/// `encode/SPEC` for every encoder of the registry, with `ns_per_cell`.
void RegisterEncodeBenchmarks();

/// `adaptive/choose/SCENE`: choosing and tracing the rays of encoder
/// `adaptive`, with the `share` that choosing costs of tracing.
void RegisterAdaptiveBenchmarks();

/// `render/SCENE` for every scene of the repository, with `rays_per_second`.
void RegisterRenderBenchmarks();

/// `rayterm/path`: the work that RAYTERM's CPU prototype was timed on, on one
/// core.
void RegisterRaytermBenchmarks();

/// `bvh/explore/QUERY/RAYS`: the flat BVH's closest hits and shadow rays in
/// millions a second, Embree's on the same rays, and the `ratio`.
void RegisterBvhBenchmarks();

/// `live/draw/PRESENTER`: drawing 120 x 40 cells of which each has changed,
/// writing to the terminal apart.
void RegisterLiveBenchmarks();

}  // namespace rtb
