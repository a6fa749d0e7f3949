/// @file
/// A record for tests.
#pragma once

#include "harness/results/run_record.h"

namespace rtb {

/// Two encoders on one scene; the second has no PSNR, MS-SSIM or times,
/// but every other measure.
RunRecord SampleRecord();

/// The record of a unit that could not be done.
RunRecord SampleFailure();

}  // namespace rtb
