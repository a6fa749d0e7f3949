/// @file
/// The flat BVH on the CPU.
#pragma once

#include <memory>

#include "core/render/backend.h"

namespace rtb {

/// Prepares a scene (which must outlive the backend) for the code
/// that a device runs too.
Result<std::unique_ptr<Backend>> MakeBvhBackend(const Scene& scene);

}  // namespace rtb
