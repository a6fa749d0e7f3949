/// @file
/// Runs an encoder on a source and times its two halves apart.
#pragma once

#include "encoders/encoder.h"

namespace rtb {

/// What a piece of work took, in milliseconds.
struct Cost {
  double wall_ms = 0;
  double cpu_ms = 0;  ///< Of all threads of the process.
};

/// An encoding and what it cost.
struct TimedEncoding {
  Encoding encoding;
  Cost render;  ///< Inside the source.
  Cost encode;  ///< All the rest.
};

/// Runs the encoder.
/// @return the source's and the encoder's errors.
Result<TimedEncoding> RunEncoder(const Encoder& encoder, FragmentSource& source,
                                 GridSize grid, double cell_aspect,
                                 const EncodeContext& context);

}  // namespace rtb
