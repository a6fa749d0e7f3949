/// @file
/// The processor time of the program.
#pragma once

namespace rtb {

/// CPU time of all threads of the process so far, in milliseconds.
double CpuMilliseconds();

}  // namespace rtb
