#include "reference/pov_light.h"

#include <cmath>
#include <numbers>

#include "core/base/check.h"
#include "core/scene/animation.h"
#include "reference/pov_material.h"
#include "reference/pov_text.h"

namespace rtb {
namespace {

constexpr double kPi = std::numbers::pi;

/// POV-Ray dims light by 2 / (1 + (d/D)^2): the inverse square but for a share
/// of (D/d)^2, with D the fade distance in units of the exported file.
constexpr double kFadeDistance = 1e-4;

/// A parallel light shines from this far away, beyond the 1e7 units at which
/// POV-Ray stops looking for surfaces.
constexpr double kFarAway = 1e8;

/// Fewest emitters that stand for an area light (a Fibonacci number).
constexpr int kFewestEmitters = 89;

/// Light of an intensity with inverse-square falloff: POV-Ray's lambertian
/// surface shows pigment * color * attenuation * cos, ours
/// albedo / pi * intensity / d^2 * cos. Intensity grows with scale^2 so that
/// the irradiance stays.
std::string InverseSquare(const Rgb& intensity, double scale) {
  const double unit = scale * scale / (2 * kPi * kFadeDistance * kFadeDistance);
  return PovColor(intensity) + " * " + PovNumber(unit) + " fade_distance " +
         PovNumber(kFadeDistance) + " fade_power 2";
}

std::string Unfaded(const Rgb& irradiance) {
  return PovColor(irradiance) + " / pi";
}

std::string LightSource(const V3d& position, const std::string& rest) {
  return "light_source { " + PovVector(position) + " " + rest + " }\n";
}

/// A small flat emitter: a spotlight whose only falloff is the cosine.
std::string Emitter(const V3d& position, const V3d& normal,
                    const Rgb& intensity, double scale) {
  const V3d at = position * scale;
  return LightSource(at, InverseSquare(intensity, scale) +
                             " spotlight point_at " + PovVector(at + normal) +
                             " radius 90 falloff 90 tightness 1");
}

/// A Fibonacci number and the one before it.
struct FibonacciPair {
  int number;
  int before;
};

FibonacciPair FibonacciAtLeast(int count) {
  FibonacciPair pair{1, 1};
  while (pair.number < count) {
    pair = {pair.number + pair.before, pair.number};
  }
  return pair;
}

double Fraction(double x) { return x - std::floor(x); }

/// Writes one light; `offset` is that of its path.
struct LightWriter {
  V3d offset;
  double scale;

  std::string operator()(const PointLight& light) const {
    return LightSource((light.position + offset) * scale,
                       light.inverse_square
                           ? InverseSquare(light.intensity, scale)
                           : Unfaded(light.intensity));
  }
  std::string operator()(const DirectionalLight& light) const {
    return LightSource(
        light.direction.normalized() * -kFarAway,
        Unfaded(light.irradiance) + " parallel point_at <0, 0, 0>");
  }
  std::string operator()(const SpotLight& light) const {
    const V3d at = (light.position + offset) * scale;
    const std::string cone = PovNumber(light.cone);
    return LightSource(
        at, InverseSquare(light.intensity, scale) + " spotlight point_at " +
                PovVector(at + light.direction.normalized()) + " radius " +
                cone + " falloff " + cone + " tightness 0");
  }
  std::string operator()(const QuadLight& light) const {
    const V3d corner = light.corner + offset;
    const V3d area = light.edges[0].cross(light.edges[1]);
    // Rank-1 lattice with Fibonacci generator: Niederreiter, "Random Number
    // Generation and Quasi-Monte Carlo Methods", 1992, section 5.
    const auto [n, generator] =
        FibonacciAtLeast(std::max(light.samples, kFewestEmitters));
    const Rgb intensity =
        light.radiance * static_cast<float>(area.length() / n);
    std::string text = QuadSurface(corner, light);
    for (int i = 0; i < n; ++i) {
      const double u = (i + 0.5) / n;
      const double v = Fraction((static_cast<double>(i) * generator + 0.5) / n);
      text += Emitter(corner + light.edges[0] * u + light.edges[1] * v,
                      area.normalized(), intensity, scale);
    }
    return text;
  }
  std::string operator()(const SphereLight& light) const {
    const V3d center = light.center + offset;
    // Half of the emitters face any one point.
    const int n =
        2 * FibonacciAtLeast(std::max(light.samples, kFewestEmitters)).number;
    const double area = 4 * kPi * light.radius * light.radius;
    const Rgb intensity = light.radiance * static_cast<float>(area / n);
    std::string text = "sphere { " + PovVector(center * scale) + ", " +
                       PovNumber(light.radius * scale) + " texture { " +
                       Glow(light.radiance) + " } }\n";
    for (int i = 0; i < n; ++i) {
      // Spherical Fibonacci points: Keinert et al., "Spherical Fibonacci
      // Mapping", SIGGRAPH Asia 2015, equation 1.
      const double z = 1 - (2 * i + 1.0) / n;
      const double angle = 2 * kPi * Fraction(i * (std::numbers::phi - 1));
      const double r = std::sqrt(1 - z * z);
      const V3d normal(r * std::cos(angle), r * std::sin(angle), z);
      text += Emitter(center + normal * light.radius, normal, intensity, scale);
    }
    return text;
  }

 private:
  static std::string Glow(const Rgb& radiance) {
    return "pigment { " + PovColor(radiance) + " } finish { emission rgb 1 }";
  }
  /// The panel as it is seen: its front glows, its back is black. POV-Ray's
  /// outside of a triangle is where it runs clockwise.
  std::string QuadSurface(const V3d& corner, const QuadLight& light) const {
    const auto at = [&](double u, double v) {
      return PovVector((corner + light.edges[0] * u + light.edges[1] * v) *
                       scale);
    };
    const std::string far = at(1, 1);
    return "mesh { triangle { " + at(0, 0) + ", " + far + ", " + at(1, 0) +
           " } triangle { " + at(0, 0) + ", " + at(0, 1) + ", " + far +
           " } texture { " + Glow(light.radiance) +
           " } interior_texture { pigment { rgb 0 } } }\n";
  }
};

}  // namespace

std::string PovLight(const Scene& scene, const Light& light, double time,
                     double scale) {
  V3d offset(0);
  if (light.path != kNone) {
    offset =
        PathOffset(scene.paths[static_cast<std::size_t>(light.path)], time);
  }
  return std::visit(LightWriter{offset, scale}, light.kind);
}

Status CheckPovLight(const Scene& scene, const Light& light) {
  const auto* spot = std::get_if<SpotLight>(&light.kind);
  if (spot == nullptr || spot->penumbra == 0) return {};
  return Fail(BadInput(
      PlaceOf(scene, light.mark),
      "POV-Ray cannot express `penumbra` of spot light `" + light.id +
          "`: its spots fade by the cosine of the angle, not by the angle",
      "set `penumbra: 0`, or use another reference"));
}

}  // namespace rtb
