/// @file
/// Encoder: turns samples into cells. The flow: Plan -> FragmentSource ->
/// Encode -> CellGrid.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/render/fragment_source.h"
#include "core/render/fragments.h"
#include "core/render/sample_plan.h"
#include "encoders/cell_grid.h"

namespace rtb {

/// One parameter of an encoder, as `list encoders` shows it.
struct EncoderParameter {
  std::string name;
  std::string default_value;
  std::string
      values;  ///< What is allowed: `srgb|linear|oklab`, `integer >= 0`.
  std::string description;
};

/// What a user may know of an encoder without making one.
struct EncoderInfo {
  std::string name;
  std::string description;
  int samples_per_cell;  ///< With default parameters.
  std::string glyphs;    ///< The code points it may use, in words.
  std::vector<EncoderParameter> parameters;
};

/// What an encoding depends on beside the fragments.
struct EncodeContext {
  std::uint64_t seed = 0;
  int threads = 0;                     ///< Upper bound; 0 = all cores.
  const CellGrid* previous = nullptr;  ///< Last frame, for temporal encoders.
};

/// An encoding and what it took.
struct Encoding {
  CellGrid grid;
  double rays_per_cell = 0;  ///< Samples really asked for, mean over cells.
};

/// An encoder with its parameters fixed. Immutable and safe to share between
/// threads; Encode is a pure function of its arguments.
class Encoder {
 public:
  virtual ~Encoder() = default;

  /// Where samples are wanted in each cell of the grid.
  /// @param cell_aspect cell width / height, passed on to the plan.
  virtual SamplePlan Plan(GridSize grid, double cell_aspect,
                          std::uint64_t seed) const = 0;

  /// Encodes the fragments that answer Plan(): linear radiance with exposure
  /// applied; values outside [0, 1] are clipped, NaN counts as 0. Works cell
  /// by cell on all cores; the result does not depend on their number.
  virtual CellGrid Encode(const Fragments& fragments,
                          const EncodeContext& context) const = 0;

  /// Asks the source and encodes. Encoders that ask in rounds override this.
  virtual Result<Encoding> Run(FragmentSource& source, GridSize grid,
                               double cell_aspect,
                               const EncodeContext& context) const;
};

}  // namespace rtb
