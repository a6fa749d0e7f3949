/// @file
/// Which channels of a file are the color, and what their values mean.
#pragma once

#include <OpenImageIO/imageio.h>

#include <span>

#include "core/math/vec.h"

namespace rtb {

/// What integer codes stand for.
enum class Codes { kSrgb, kValues };

/// Turns a file's channel values into linear RGB over black.
class PixelDecoder {
 public:
  /// Looks for R, G and B by name, in any order and in the first layer that
  /// has all three; else for one gray channel; else takes the first three.
  PixelDecoder(const OIIO::ImageSpec& spec, Codes codes);

  /// The channels [begin, end) of the file that Linear() needs.
  int begin() const { return begin_; }
  int end() const { return end_; }

  /// @param values the channels [begin, end) of one pixel, integer ones
  ///     scaled to [0, 1].
  Rgb Linear(std::span<const float> values) const;

 private:
  enum class Coding { kCodes8, kEncoded, kLinear };

  float Decode(float value) const;

  Coding coding_;
  int red_, green_, blue_;
  int alpha_ = -1;  ///< Only where color is yet to be multiplied by it.
  int begin_, end_;
};

}  // namespace rtb
