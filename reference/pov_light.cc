#include "reference/pov_light.h"

#include <algorithm>
#include <numbers>

#include "core/scene/animation.h"
#include "reference/pov_area_light.h"
#include "reference/pov_text.h"

namespace rtb {
namespace {

constexpr double kPi = std::numbers::pi;

/// A parallel light shines from this far away, beyond the 1e7 units at which
/// POV-Ray stops looking for surfaces.
constexpr double kFarAway = 1e8;

std::string InverseSquare(const Rgb& intensity, double scale) {
  return PovIntensity(intensity, scale) + " " + PovFade();
}

std::string Unfaded(const Rgb& irradiance) {
  return PovColor(irradiance) + " / pi";
}

std::string LightSource(const V3d& position, const std::string& rest) {
  return "light_source { " + PovVector(position) + " " + rest + " }\n";
}

/// Radius, in units of the exported file, of the shell that holds a spot's
/// penumbra: ten times the tolerance of POV-Ray's shadows.
constexpr double kShellRadius = 0.01;

/// The share of light that an angle `theta` off the axis gets, in 0.25 to 0.75
/// (a function's value of 1 would wrap around), as SDL of x, y, z.
std::string PenumbraFunction(const SpotLight& light) {
  const V3d d = light.direction.normalized();
  const auto rad = [](double deg) { return PovNumber(deg * kPi / 180); };
  return "function { 0.25 + 0.5 * Smoothstep(max(0, min(1, (" +
         rad(light.cone + light.penumbra) + " - acos(max(-1, min(1, x * " +
         PovNumber(d.x) + " + y * " + PovNumber(d.y) + " + z * " +
         PovNumber(d.z) + ")))) / " + rad(light.penumbra) + "))) }";
}

/// A shell around a light that only shadow rays meet, and that lets through
/// what the penumbra leaves. POV-Ray's own spots fade by the cosine of the
/// angle instead of by the angle.
std::string PenumbraShell(const V3d& at, const SpotLight& light) {
  return "sphere { <0, 0, 0>, 1 texture { pigment { " +
         PenumbraFunction(light) +
         " color_map { [0.25 rgb 0] [0.75 rgb 0 transmit 1] } } } scale " +
         PovNumber(kShellRadius) + " translate " + PovVector(at) +
         " no_image no_reflection }\n";
}

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
    const std::string shine = InverseSquare(light.intensity, scale);
    if (light.penumbra > 0) {
      return LightSource(at, shine) + PenumbraShell(at, light);
    }
    const std::string cone = PovNumber(light.cone);
    return LightSource(at, shine + " spotlight point_at " +
                               PovVector(at + light.direction.normalized()) +
                               " radius " + cone + " falloff " + cone +
                               " tightness 0");
  }
  std::string operator()(const QuadLight& light) const {
    return PovQuadLight(light, offset, scale);
  }
  std::string operator()(const SphereLight& light) const {
    return PovSphereLight(light, offset, scale);
  }
};

constexpr char kSmoothstep[] =
    "#declare Smoothstep = function(S) { S * S * (3 - 2 * S) }\n";

bool HasPenumbra(const Light& light) {
  const auto* spot = std::get_if<SpotLight>(&light.kind);
  return spot != nullptr && spot->penumbra > 0;
}

bool HasArea(const Light& light) {
  return std::holds_alternative<QuadLight>(light.kind) ||
         std::holds_alternative<SphereLight>(light.kind);
}

std::string PovLight(const Scene& scene, const Light& light, double time,
                     double scale) {
  V3d offset(0);
  if (light.path != kNone) {
    offset =
        PathOffset(scene.paths[static_cast<std::size_t>(light.path)], time);
  }
  return std::visit(LightWriter{offset, scale}, light.kind);
}

}  // namespace

std::string PovLights(const Scene& scene, double time, double scale) {
  std::string text;
  if (std::any_of(scene.lights.begin(), scene.lights.end(), HasArea)) {
    text += PovEmitterMacros();
  }
  if (std::any_of(scene.lights.begin(), scene.lights.end(), HasPenumbra)) {
    text += kSmoothstep;
  }
  for (const Light& light : scene.lights) {
    text += PovLight(scene, light, time, scale);
  }
  return text;
}

}  // namespace rtb
