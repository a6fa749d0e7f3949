#include "reference/pov_text.h"

#include <array>
#include <charconv>

namespace rtb {
namespace {

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

Affined ScaledBy(const Affined& map, double scale) {
  Affined scaled;
  scaled.x = map.x * scale;
  scaled.y = map.y * scale;
  scaled.z = map.z * scale;
  scaled.origin = map.origin * scale;
  return scaled;
}

}  // namespace rtb
