/// @file
/// PlanEncoder: an encoder that asks for all its samples at once.
#pragma once

#include <cstdint>

#include "core/render/fragments.h"
#include "core/render/sample_plan.h"
#include "encoders/encoder.h"

namespace rtb {

/// Plan -> FragmentSource -> Encode.
class PlanEncoder : public Encoder {
 public:
  Result<Encoding> Run(FragmentSource& source, GridSize grid,
                       double cell_aspect,
                       const EncodeContext& context) const final;

 protected:
  /// Where samples are wanted in each cell of the grid.
  virtual SamplePlan Plan(GridSize grid, double cell_aspect,
                          std::uint64_t seed) const = 0;

  /// Encodes the fragments that answer Plan(). A pure function of its
  /// arguments.
  virtual Result<CellGrid> Encode(const Fragments& fragments,
                                  const EncodeContext& context) const = 0;
};

}  // namespace rtb
