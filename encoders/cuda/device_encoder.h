/// @file
/// DeviceEncoder: encoders whose cells are chosen on the GPU, so that a frame
/// sends cells over the bus, not samples. The flow: Plan -> Submit -> the
/// backend's kernel, then the encoder's -> Collect -> CellGrid.
#pragma once

#include <memory>
#include <string>

#include "core/base/result.h"
#include "core/render/cuda_backend.h"
#include "encoders/cell_grid.h"

namespace rtb {

/// half, quadrant, sextant, octant or tiv, with their default parameters.
/// Frames may be under way as AheadBackend allows.
class DeviceEncoder {
 public:
  /// @return kBadInput for another encoder, kMissing where no GPU can be used.
  static Result<std::unique_ptr<DeviceEncoder>> Make(const std::string& name);

  virtual ~DeviceEncoder() = default;

  /// What Submit has rendered; the same as the encoder's of that name.
  virtual SamplePlan Plan(GridSize grid, double cell_aspect) const = 0;
  /// Begins a frame of a plan that Plan gave.
  /// @param exposure in stops: radiance is multiplied by 2^exposure.
  virtual Status Submit(AheadBackend& backend, const SamplePlan& plan,
                        const RenderOptions& options, double exposure) = 0;
  /// Waits for the oldest frame under way; there is one.
  virtual Result<CellGrid> Collect(AheadBackend& backend) = 0;
};

}  // namespace rtb
