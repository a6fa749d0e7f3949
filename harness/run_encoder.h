/// @file
/// Runs an encoder on a source and times its two halves apart.
#pragma once

#include "encoders/encoder.h"

namespace rtb {

/// An encoding and what it cost, in milliseconds.
struct TimedEncoding {
  Encoding encoding;
  double render_ms = 0;  ///< Wall time inside the source.
  double encode_ms = 0;  ///< Wall time of the rest.
  double cpu_ms = 0;     ///< CPU time of all threads, for both.
};

/// Plans, asks the source and encodes.
/// @return kBadInput when the grid asks for more than kMaxSamples samples,
/// and the source's and encoder's errors.
Result<TimedEncoding> RunEncoder(const Encoder& encoder, FragmentSource& source,
                                 GridSize grid, double cell_aspect,
                                 const EncodeContext& context);

}  // namespace rtb
