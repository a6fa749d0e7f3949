/// @file
/// Decompose: how much of a run's error comes from rendering, from sampling,
/// from encoding and from a font's shapes.
#pragma once

#include "harness/measure/error_input.h"
#include "harness/results/decomposition.h"

namespace rtb {

/// The images of a run, from reference to grid, of one size; sRGB-encoded
/// values.
struct ErrorSteps {
  Image reference;  ///< R
  Image converged;  ///< I_inf
  Image fragments;  ///< I_n: what the encoder saw.
  Image grid;       ///< T
};

/// What the encoder saw, each pixel the nearest sample of its own cell, in
/// sRGB-encoded values at the decoded grid's size.
Image FragmentsImage(const Encoding& encoding, const DecodeOptions& decode);

/// The six terms of |T - R|^2 and their sum; `font` is left out.
MseTerms SplitMse(const ErrorSteps& steps, int threads);

/// The encoder's own error against what it saw, on the decoded grid's raster.
Result<InnerTerms> SplitEncoding(const ErrorInput& input);

/// All of it. @return the errors of decoding.
Result<Decomposition> Decompose(const ErrorInput& input);

}  // namespace rtb
