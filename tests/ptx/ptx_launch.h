// Runs translated kernels.
#pragma once

#include <cstddef>
#include <cstdint>

#include "tests/ptx/ptx_machine.h"

namespace rtb::testing {

/// Runs a translated kernel for every thread of every block.
template <class Job>
void LaunchPtx(void (*kernel)(unsigned char*), Job job, std::size_t count) {
  constexpr std::uint32_t kThreads = 64;
  ptx_ntid = {kThreads, 1, 1};
  const auto blocks = (count + kThreads - 1) / kThreads;
  ptx_nctaid = {static_cast<std::uint32_t>(blocks), 1, 1};
  for (ptx_ctaid.x = 0; ptx_ctaid.x < ptx_nctaid.x; ++ptx_ctaid.x) {
    for (ptx_tid.x = 0; ptx_tid.x < kThreads; ++ptx_tid.x) {
      kernel(reinterpret_cast<unsigned char*>(&job));
    }
  }
}

}  // namespace rtb::testing
