/// @file
/// Runs code on every vector instruction set that the processor supports and
/// the library holds (Highway's targets), to prove that all say the same.
#pragma once

#include <gtest/gtest.h>
#include <hwy/highway.h>

#include <cstdint>

namespace rtb {

/// Calls `body()` once for each target, the last time for the best one, which
/// stays chosen.
template <class Body>
void ForEachSimdTarget(const Body& body) {
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    SCOPED_TRACE(hwy::TargetName(target));
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().Update(target);
    body();
  }
  hwy::SetSupportedTargetsForTest(0);
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

}  // namespace rtb
