/// @file
/// ErrorInput: one encoder's run, with what its error is measured against.
#pragma once

#include <filesystem>
#include <string>

#include "core/image/image.h"
#include "encoders/color_depth.h"
#include "encoders/decode.h"
#include "encoders/encoder.h"
#include "harness/prepared_scene.h"

namespace rtb {

/// All references must outlive it.
struct ErrorInput {
  const PreparedScene& scene;
  std::string spec;  ///< The encoder's, for errors.
  const Encoder& encoder;
  const Encoding& encoding;  ///< With its evidence.
  /// As displayed: sRGB-encoded, rounded to 8 bits. At its own size, of the
  /// grid's aspect.
  const Image& reference;
  /// Our converged image as displayed but not rounded, at the size of the
  /// decoded grid.
  const Image& converged;
  DecodeOptions decode;
  ColorDepth depth = ColorDepth::kTruecolor;
  std::filesystem::path cache;  ///< Of cache.h; empty: none.
};

}  // namespace rtb
