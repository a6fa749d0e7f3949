#include "reference/pov_text.h"

#include <array>
#include <charconv>
#include <numbers>

namespace rtb {
namespace {

/// POV-Ray dims light by 2 / (1 + (d/D)^2): the inverse square but for a share
/// of (D/d)^2, with D the fade distance in units of the exported file.
constexpr double kFadeDistance = 1e-4;

/// Adding 0 turns -0 into 0.
template <class T>
std::string Shortest(T value) {
  std::array<char, 32> text;
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value + T(0)).ptr;
  return std::string(text.data(), end);
}

template <class Vec>
std::string Components(const Vec& v) {
  return PovNumber(v.x) + ", " + PovNumber(v.y) + ", " + PovNumber(v.z);
}

}  // namespace

std::string PovNumber(double value) { return Shortest(value); }
std::string PovNumber(float value) { return Shortest(value); }

std::string PovVector(const V3d& v) { return "<" + Components(v) + ">"; }
std::string PovVector(const V3f& v) { return "<" + Components(v) + ">"; }

std::string PovColor(const Rgb& color) { return "rgb " + PovVector(color); }

std::string PovMatrix(const Affined& map) {
  return "matrix <" + Components(map.x) + ", " + Components(map.y) + ", " +
         Components(map.z) + ", " + Components(map.origin) + ">";
}

// POV-Ray's lambertian surface shows pigment * color * attenuation * cos, ours
// albedo / pi * intensity / d^2 * cos. Intensity grows with scale^2 so that
// the irradiance stays.
std::string PovIntensity(const Rgb& intensity, double scale) {
  return PovColor(intensity) + " * " +
         PovNumber(scale * scale /
                   (2 * std::numbers::pi * kFadeDistance * kFadeDistance));
}

std::string PovFade() {
  return "fade_distance " + PovNumber(kFadeDistance) + " fade_power 2";
}

Affined ScaledBy(const Affined& map, double scale) {
  Affined scaled;
  scaled.x = map.x * scale;
  scaled.y = map.y * scale;
  scaled.z = map.z * scale;
  scaled.origin = map.origin * scale;
  return scaled;
}

}  // namespace rtb
