#include "core/shading/light_make.h"

#include <cmath>
#include <numbers>
#include <variant>

#include "core/color/luminance.h"

namespace rtb {
namespace {

constexpr double kPiExact = std::numbers::pi;

float Radians(double degrees) {
  return static_cast<float>(degrees * kPiExact / 180);
}

/// A flat light from its corner and edges.
LightData FlatLight(LightModel model, const V3d& corner, const V3d& e0,
                    const V3d& e1, const Rgb& radiance) {
  // Edges of any size: unit ones have a cross product that is a sine.
  const double sizes = e0.length() * e1.length();
  const V3d cross = e0.normalized().cross(e1.normalized());
  LightData light;
  light.model = model;
  light.position = V3f(corner);
  light.direction = V3f(cross.normalized());
  light.color = radiance;
  light.edge0 = V3f(e0);
  light.edge1 = V3f(e1);
  const double share = model == LightModel::kTriangle ? 0.5 : 1;
  light.area = static_cast<float>(share * sizes * cross.length());
  return light;
}

/// Turns each kind of light into plain data, moved by its path's offset.
struct LightConverter {
  V3d offset;

  LightData operator()(const PointLight& light) const {
    LightData data;
    data.position = V3f(light.position + offset);
    data.color = light.intensity;
    data.inverse_square = light.inverse_square;
    return data;
  }
  LightData operator()(const DirectionalLight& light) const {
    LightData data;
    data.model = LightModel::kDirectional;
    data.direction = V3f(light.direction.normalized());
    data.color = light.irradiance;
    return data;
  }
  LightData operator()(const SpotLight& light) const {
    LightData data;
    data.model = LightModel::kSpot;
    data.position = V3f(light.position + offset);
    data.direction = V3f(light.direction.normalized());
    data.color = light.intensity;
    data.cone = Radians(light.cone);
    data.penumbra = Radians(light.penumbra);
    return data;
  }
  LightData operator()(const QuadLight& light) const {
    const V3d& e0 = light.edges[0];
    const V3d& e1 = light.edges[1];
    LightData data = FlatLight(LightModel::kQuad, light.corner + offset, e0, e1,
                               light.radiance);
    data.samples = light.samples;
    // What a single-precision vector can tell from a right angle.
    data.rectangle = std::abs(e0.normalized().dot(e1.normalized())) < 1e-6;
    return data;
  }
  LightData operator()(const SphereLight& light) const {
    LightData data;
    data.model = LightModel::kSphere;
    data.position = V3f(light.center + offset);
    data.color = light.radiance;
    data.radius = static_cast<float>(light.radius);
    data.samples = light.samples;
    return data;
  }
};

}  // namespace

LightData ToLightData(const Light& light, const V3d& offset) {
  return std::visit(LightConverter{offset}, light.kind);
}

LightData TriangleLight(const V3f& a, const V3f& b, const V3f& c,
                        const Rgb& radiance) {
  return FlatLight(LightModel::kTriangle, V3d(a), V3d(b) - V3d(a),
                   V3d(c) - V3d(a), radiance);
}

double LightPower(const LightData& light, double scene_radius) {
  const double color = Luminance(light.color);
  const double disk = kPiExact * scene_radius * scene_radius;
  switch (light.model) {
    case LightModel::kPoint:
      return light.inverse_square ? color * 4 * kPiExact : color * disk;
    case LightModel::kDirectional:
      return color * disk;
    case LightModel::kSpot:
      return color * 2 * kPiExact *
             (1 - std::cos(light.cone + light.penumbra / 2.0));
    case LightModel::kQuad:
      return color * kPiExact * light.area;
    case LightModel::kTriangle:
      return color * 2 * kPiExact * light.area;
    case LightModel::kSphere:
      return color * kPiExact * 4 * kPiExact * std::pow(light.radius, 2.0);
  }
  return 0;
}

}  // namespace rtb
