/// @file
/// Workbench: what the units of one scene share, kept from unit to unit.
#pragma once

#include <string>

#include "harness/bench.h"
#include "harness/sweep/unit.h"

namespace rtb {

/// Holds one scene and one reference at a time, so that units in the order of
/// Expand load and render each once. For one thread at a time.
class Workbench {
 public:
  /// @param threads of each unit's own loops; 0 = all cores.
  explicit Workbench(int threads) : threads_(threads) {}

  /// The unit's scene, ready to render with the unit's options. Valid until
  /// the next call.
  Result<const PreparedScene*> Scene(const SweepUnit& unit);

  /// The unit's reference for the raster of its grid; the same holds.
  Result<const ReferencePicture*> Reference(const SweepUnit& unit);

  int threads() const { return threads_; }

 private:
  int threads_;
  std::string scene_key_;
  Result<PreparedScene> scene_ = Fail(Error{});
  std::string reference_key_;
  Result<ReferencePicture> reference_ = Fail(Error{});
};

/// What the unit asks of the main job.
BenchRequest RequestOf(const SweepUnit& unit, int threads);

}  // namespace rtb
