/// @file
/// References by Cycles, Blender's path tracer.
#pragma once

#include "core/base/result.h"
#include "core/scene/scene.h"
#include "reference/reference.h"

namespace rtb {

/// Samples per pixel of a reference unless told.
inline constexpr int kCyclesSpp = 1024;

/// Samples of one program run.
inline constexpr int kCyclesPassSpp = 64;

/// Highest seed.
inline constexpr int kMaxCyclesSeed = 1'000'000;

/// Renders a reference with Blender Cycles in passes of at most
/// kCyclesPassSpp samples, each the next of one sequence, that survive an
/// interruption (a second call with the same request continues); averages
/// them in double precision, and writes a half-float EXR and a provenance
/// JSON, both atomically. No denoiser, no clamping, no adaptive sampling.
/// @return kMissing (with how to get it) when blender is not installed.
Status RenderCyclesReference(const Scene& scene,
                             const ReferenceRequest& request,
                             const Progress& progress);

}  // namespace rtb
