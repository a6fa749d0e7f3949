/// @file
/// Numbers, vectors and maps as POV-Ray's scene description language (SDL)
/// writes them. Every number is the shortest that reads back the same,
/// whatever the locale.
#pragma once

#include <string>

#include "core/math/affine.h"
#include "core/math/vec.h"

namespace rtb {

/// A number.
std::string PovNumber(double value);
/// A number, with the digits that single precision needs.
std::string PovNumber(float value);
/// `<x, y, z>`
std::string PovVector(const V3d& v);
/// `<x, y, z>`
std::string PovVector(const V3f& v);
/// `rgb <r, g, b>`: scene-linear, since the file says `assumed_gamma 1.0`.
std::string PovColor(const Rgb& color);
/// `matrix <...>`: the images of the three axes, then of the origin.
std::string PovMatrix(const Affined& map);

/// `rgb <r, g, b> * k`: the color of a light of an intensity (W/sr in the
/// scene's units) that dims as PovFade says, in a world larger by `scale`.
std::string PovIntensity(const Rgb& intensity, double scale);
/// The inverse square law, but for a share of less than 1e-8 at distance 1.
std::string PovFade();

/// The map followed by a uniform scaling of space.
Affined ScaledBy(const Affined& map, double scale);

}  // namespace rtb
