/// @file
/// MeasureTemporal: how steady an encoder draws a moving scene, against our
/// own converged frames.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "encoders/color_depth.h"
#include "encoders/decode.h"
#include "harness/prepared_scene.h"
#include "harness/results/temporal_result.h"

namespace rtb {

/// The least number of frames from which figures are made.
inline constexpr int kLeastFrames = 24;

/// What to measure. The scene's options give spp, seed, integrator, threads and
/// the time of the first frame.
struct TemporalRequest {
  const PreparedScene& scene;
  std::string encoder;  ///< One SPEC.
  GridSize grid{120, 40};
  ColorDepth depth = ColorDepth::kTruecolor;
  DecodeOptions decode;
  int frames = kLeastFrames;
  double fps = 24;
  std::filesystem::path cache = {};  ///< Of the reference frames; empty: none.
};

/// Draws the frames one after the other, each with its predecessor's grid as
/// the encoder's `previous`, and measures what docs/measures.md defines under
/// "Moving scenes".
/// @param progress called with the finished share.
/// @return kBadInput for fewer than kLeastFrames frames, a frame rate that is
///   not positive, a bad SPEC or grid; the errors of rendering and encoding.
Result<TemporalResult> MeasureTemporal(
    const TemporalRequest& request,
    const std::function<void(double share, const std::string& what)>& progress);

}  // namespace rtb
