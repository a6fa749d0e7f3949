/// @file
/// Runs an encoder on a source and times its parts apart.
#pragma once

#include "encoders/encoder.h"
#include "harness/stopwatch.h"

namespace rtb {

/// An encoding and what it cost: the three parts are all of Encoder::Run.
struct TimedEncoding {
  Encoding encoding;
  Cost plan;    ///< Until the source is asked first.
  Cost render;  ///< Inside the source: rays, and exposure where it is not 0.
  /// From the first fragments on, outside the source: encoding, freeing the
  /// fragments, and the plans of further rounds where an encoder asks again.
  Cost encode;
};

/// Runs the encoder.
/// @return the source's and the encoder's errors.
Result<TimedEncoding> RunEncoder(const Encoder& encoder, FragmentSource& source,
                                 GridSize grid, double cell_aspect,
                                 const EncodeContext& context);

}  // namespace rtb
