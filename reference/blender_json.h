/// @file
/// Vectors, colors, maps and arrays in the JSON that Blender's Python reads.
#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>

#include "core/image/image.h"
#include "core/math/affine.h"
#include "core/math/vec.h"

namespace rtb {

/// `[x, y, z]`
nlohmann::ordered_json BlenderVector(const V3d& v);
/// `[r, g, b]`, scene-linear.
nlohmann::ordered_json BlenderColor(const Rgb& color);
/// The images of the three axes, then of the origin: twelve numbers.
nlohmann::ordered_json BlenderMatrix(const Affined& map);

/// The numbers' bytes, in the machine's order, as base64: exact, and read at
/// once however many there are.
std::string BlenderArray(std::span<const float> numbers);
std::string BlenderArray(std::span<const int> numbers);

/// `{width, height, pixels}`: linear RGB floats, rows from the bottom up.
nlohmann::ordered_json BlenderImage(const Image& linear);

}  // namespace rtb
