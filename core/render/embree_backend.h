/// @file
/// The Embree backend.
#pragma once

#include <memory>

#include "core/render/backend.h"

namespace rtb {

/// Prepares a scene (which must outlive the backend) for Embree.
Result<std::unique_ptr<Backend>> MakeEmbreeBackend(const Scene& scene);

}  // namespace rtb
