/// @file
/// The lights of a scene at a time: those declared, and what of emissive
/// objects can be sampled.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/accel/surface.h"
#include "core/color/luminance.h"
#include "core/math/discrete.h"
#include "core/scene/animation.h"
#include "core/shading/light_choice.h"
#include "core/shading/light_make.h"
#include "core/shading/shading_scene.h"

namespace rtb {
namespace {

/// Emitters past this number are found by chance alone: their choice would
/// cost more than it brings.
constexpr std::size_t kMostEmitters = std::size_t{1} << 16;

/// Adds the triangles and spheres of emissive objects to the lights.
class EmitterFinder {
 public:
  EmitterFinder(const Geometry& geometry, ShadingScene* shading)
      : geometry_(geometry), shading_(*shading) {}

  void Find() {
    EmitterIndices& found = shading_.emitters;
    found = {};
    shading_.unsampled_emitters = AnyUnsampled();
    if (!AnyEmissive()) return;
    for (std::size_t i = 0; i < geometry_.triangle_objects.size(); ++i) {
      const V3f* v = geometry_.vertices.data() + 3 * i;
      const Rgb radiance = RadianceOf(geometry_.triangle_objects[i]);
      found.triangles.push_back(
          radiance == Rgb(0) ? -1
                             : Add(TriangleLight(v[0], v[1], v[2], radiance)));
    }
    for (const Quadric& sphere : geometry_.spheres) {
      found.spheres.push_back(Add(SphereOf(sphere)));
    }
    for (const MeshUse& use : geometry_.uses) {
      found.uses.push_back(AddMesh(use));
    }
  }

 private:
  bool AnyEmissive() const {
    const auto& materials = shading_.materials;
    return std::any_of(materials.begin(), materials.end(), [](const auto& m) {
      return m.bsdf.model == SurfaceModel::kEmissive && m.bsdf.color != Rgb(0);
    });
  }

  /// Whether something shines from where Add takes nothing: disks, planes,
  /// and spheres that are squeezed or hold what they light.
  bool AnyUnsampled() const {
    const auto shines = [&](const auto& shape) {
      return RadianceOf(shape.object) != Rgb(0);
    };
    return std::any_of(geometry_.disks.begin(), geometry_.disks.end(),
                       shines) ||
           std::any_of(geometry_.planes.begin(), geometry_.planes.end(),
                       shines) ||
           std::any_of(geometry_.spheres.begin(), geometry_.spheres.end(),
                       shines);
  }

  /// What an object emits; black for what is no emissive object.
  Rgb RadianceOf(int object) const {
    const ObjectData& data =
        geometry_.objects[static_cast<std::size_t>(object)];
    if (data.light >= 0 || data.material < 0) return Rgb(0);
    const BsdfData& bsdf =
        shading_.materials[static_cast<std::size_t>(data.material)].bsdf;
    return bsdf.model == SurfaceModel::kEmissive ? bsdf.color : Rgb(0);
  }

  /// @return the light's index, or -1 for one that is black or too many.
  int Add(const LightData& light) {
    const bool shines =
        light.color != Rgb(0) && (light.area > 0 || light.radius > 0);
    if (!shines) return -1;
    if (shading_.lights.size() >= kMostEmitters) {
      shading_.unsampled_emitters = true;
      return -1;
    }
    shading_.lights.push_back(light);
    return static_cast<int>(shading_.lights.size()) - 1;
  }

  /// A sphere light where the quadric is a sphere, else a black one.
  LightData SphereOf(const Quadric& sphere) const {
    const Affinef& m = sphere.to_world;
    const float x = m.x.length(), y = m.y.length(), z = m.z.length();
    const float largest = std::max({x, y, z});
    const float skew = std::max({std::abs(m.x.dot(m.y)), std::abs(m.y.dot(m.z)),
                                 std::abs(m.z.dot(m.x))});
    const float tolerance = 1e-5f * largest;
    const bool round = largest - std::min({x, y, z}) <= tolerance &&
                       skew <= tolerance * largest;
    LightData light;
    light.model = LightModel::kSphere;
    light.position = sphere.center;
    light.radius = largest;
    light.color = round ? RadianceOf(sphere.object) : Rgb(0);
    return light;
  }

  /// All triangles of a placed mesh, or none. @return the first one's index.
  int AddMesh(const MeshUse& use) {
    const Rgb radiance = RadianceOf(use.object);
    const MeshData& mesh = geometry_.meshes[static_cast<std::size_t>(use.mesh)];
    const auto count = static_cast<std::size_t>(mesh.triangle_count);
    if (radiance == Rgb(0)) return -1;
    if (shading_.lights.size() + count > kMostEmitters) {
      shading_.unsampled_emitters = true;
      return -1;
    }
    const auto first = static_cast<int>(shading_.lights.size());
    for (std::size_t i = 0; i < count; ++i) {
      const auto& [a, b, c] = mesh.triangles[i];
      const auto at = [&](int k) {
        return use.to_world.Point(mesh.positions[k]);
      };
      shading_.lights.push_back(TriangleLight(at(a), at(b), at(c), radiance));
    }
    return first;
  }

  const Geometry& geometry_;
  ShadingScene& shading_;
};

/// Half the diagonal of what is finite, roughly: for weighing lights only.
double RadiusOf(const Geometry& geometry) {
  V3f low(std::numeric_limits<float>::max());
  V3f high = -low;
  const auto add = [&](const V3f& p) {
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], p[axis]);
      high[axis] = std::max(high[axis], p[axis]);
    }
  };
  for (const V3f& v : geometry.vertices) add(v);
  for (const Quadric& sphere : geometry.spheres) {
    add(sphere.center - sphere.half_extent);
    add(sphere.center + sphere.half_extent);
  }
  for (const MeshUse& use : geometry.uses) {
    const MeshData& mesh = geometry.meshes[static_cast<std::size_t>(use.mesh)];
    add(use.to_world.Point(mesh.positions[0]));
  }
  const double radius = (V3d(high) - V3d(low)).length() / 2;
  return low.x <= high.x && radius > 0 ? radius : 1;
}

/// Power that the background sends onto a disk of the scene's size from all
/// directions.
double BackgroundPower(const ShadingScene& shading, double radius) {
  double mean = (Luminance(shading.background.bottom) +
                 Luminance(shading.background.top)) /
                2;
  if (!shading.environment.image.empty()) {
    mean = shading.environment.mean_luminance;
  }
  return 4 * std::numbers::pi * std::numbers::pi * radius * radius * mean;
}

}  // namespace

void PlaceLights(const Scene& scene, double time, const Geometry& geometry,
                 ShadingScene* shading) {
  shading->lights.clear();
  for (const Light& light : scene.lights) {
    shading->lights.push_back(
        ToLightData(light, LightOffset(scene, light, time)));
  }
  shading->declared_lights = static_cast<int>(shading->lights.size());
  EmitterFinder(geometry, shading).Find();
  const double radius = RadiusOf(geometry);
  std::vector<double> powers;
  for (const LightData& light : shading->lights) {
    powers.push_back(LightPower(light, radius));
  }
  powers.push_back(BackgroundPower(*shading, radius));
  shading->light_cdf = MakeCdf(ChoiceWeights(powers, scene.lights.size()));
}

}  // namespace rtb
