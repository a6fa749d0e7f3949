/// @file
/// The GPU that is used: the first one, in the order of CUDA_VISIBLE_DEVICES.
#pragma once

#include "core/base/result.h"

namespace rtb {

/// Makes it current. CUDA's runtime, which is part of the program, looks for
/// the driver here, when first called.
/// @return a kMissing Error where there is no driver, no device, or none of
/// compute capability 7.5 or newer.
Status UseCudaDevice();

}  // namespace rtb
