/// @file
/// The path integrator of path.h on vectors of paths.
#pragma once

#include <cstdint>

#include "core/render/ray_counts.h"
#include "core/render/wide/paths.h"
#include "core/render/wide/wide_scene.h"

namespace rtb {

/// Follows paths from their eye rays to their ends, to the very radiances of
/// PathTracer::Radiance where the library's sine and cosine are those of
/// random-inl.h; on the widest vectors that the processor has.
/// @param paths with count, eye rays, patterns and indices.
/// @param seed,max_depth those of EyeSample and PathTracer.
/// @param counts to which the rays traced are added.
void TracePaths(const WideScene& scene, std::uint64_t seed, int max_depth,
                Paths* paths, RayCounts* counts);

}  // namespace rtb
