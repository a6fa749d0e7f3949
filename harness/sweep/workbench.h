/// @file
/// Workbench: what the units of one scene share, kept from unit to unit.
#pragma once

#include <string>

#include "harness/bench.h"
#include "harness/sweep/unit.h"

namespace rtb {

/// Holds one scene and one reference of it at a time, so that units in the
/// order of Expand load and render each once. For one thread at a time.
class Workbench {
 public:
  /// @param threads of each unit's own loops; 0 = all cores.
  explicit Workbench(int threads) : threads_(threads) {}

  /// The unit's scene, ready to render with the unit's options. Valid until
  /// the next call.
  Result<const PreparedScene*> Scene(const SweepUnit& unit);

  /// The scene with its reference and our own picture for the raster of the
  /// unit's grid; the same holds.
  Result<BenchStage> Stage(const SweepUnit& unit);

  int threads() const { return threads_; }

 private:
  int threads_;
  std::string scene_key_;
  Result<PreparedScene> scene_ = Fail(Error{});
  std::string reference_key_;
  Result<ReferencePicture> reference_ = Fail(Error{});
  std::string converged_key_;
  Result<Image> converged_ = Fail(Error{});
};

/// What the unit asks of the main job: scores and times are left to its kind.
BenchRequest RequestOf(const SweepUnit& unit, int threads);

}  // namespace rtb
