#include "core/color/ciede2000.h"

#include <cmath>
#include <numbers>

namespace rtb {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

/// Opposite hues differ by 180 degrees up to rounding; the formula's mean hue
/// jumps beyond 180, so the tie is decided with this much tolerance.
constexpr double kHueTie = 1e-9;

/// Lightness, modified chroma C' and hue h' in [0, 360) of one color.
struct Lch {
  double l, c, h;
};

/// Differences and means of two colors, equations (8)-(14).
struct LchPair {
  double dl, dc, dh;  ///< dh is the metric difference dH'.
  double l, c, h;     ///< Means.
};

double Power7(double x) {
  const double x3 = x * x * x;
  return x3 * x3 * x;
}

/// sqrt(c^7 / (c^7 + 25^7)), of equations (4) and (17).
double ChromaTerm(double c) {
  const double c7 = Power7(c);
  return std::sqrt(c7 / (c7 + Power7(25)));
}

/// Equations (5)-(7); `g` is that of equation (4).
Lch ToLch(const V3d& lab, double g) {
  const double a = (1 + g) * lab.y;
  const double c = std::hypot(a, lab.z);
  double h = c == 0 ? 0 : std::atan2(lab.z, a) / kDegree;
  if (h < 0) h += 360;
  return {lab.x, c, h};
}

LchPair Compare(const Lch& first, const Lch& second) {
  LchPair pair = {
      second.l - first.l,       second.c - first.c,       0,
      (first.l + second.l) / 2, (first.c + second.c) / 2, first.h + second.h};
  if (first.c * second.c == 0) return pair;  // Hue means nothing on gray.
  double turn = second.h - first.h;
  pair.h /= 2;
  if (std::abs(turn) > 180 + kHueTie) {
    turn += turn > 0 ? -360 : 360;
    pair.h += pair.h < 180 ? 180 : -180;
  }
  pair.dh = 2 * std::sqrt(first.c * second.c) * std::sin(turn / 2 * kDegree);
  return pair;
}

double Cosine(double degrees) { return std::cos(degrees * kDegree); }

double Square(double x) { return x * x; }

}  // namespace

double Ciede2000(const V3d& lab1, const V3d& lab2) {
  const double mean_c =
      (std::hypot(lab1.y, lab1.z) + std::hypot(lab2.y, lab2.z)) / 2;
  const double g = 0.5 * (1 - ChromaTerm(mean_c));
  const LchPair p = Compare(ToLch(lab1, g), ToLch(lab2, g));
  // Equations (15)-(21).
  const double t = 1 - 0.17 * Cosine(p.h - 30) + 0.24 * Cosine(2 * p.h) +
                   0.32 * Cosine(3 * p.h + 6) - 0.20 * Cosine(4 * p.h - 63);
  const double turn = 30 * std::exp(-Square((p.h - 275) / 25));
  const double l50 = Square(p.l - 50);
  const double sl = 1 + 0.015 * l50 / std::sqrt(20 + l50);
  const double sc = 1 + 0.045 * p.c;
  const double sh = 1 + 0.015 * p.c * t;
  const double rt = -std::sin(2 * turn * kDegree) * 2 * ChromaTerm(p.c);
  // Equation (22).
  const double l = p.dl / sl;
  const double c = p.dc / sc;
  const double h = p.dh / sh;
  return std::sqrt(l * l + c * c + h * h + rt * c * h);
}

}  // namespace rtb
