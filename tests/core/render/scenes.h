// Small scenes, built in code, for the tests of the renderer.
#pragma once

#include <string>
#include <utility>

#include "core/render/backend.h"

namespace rtb::testing {

/// A scene under construction: camera at the origin looking along -z.
class SceneBuilder {
 public:
  /// Adds a material; its index.
  template <class Bsdf>
  Index Add(Bsdf bsdf, Texture texture = {}) {
    Material material;
    material.id = "m" + std::to_string(scene.materials.size());
    material.bsdf = std::move(bsdf);
    material.texture = std::move(texture);
    scene.materials.push_back(std::move(material));
    return static_cast<Index>(scene.materials.size()) - 1;
  }
  /// Adds an object of that material; a reference to it.
  template <class Shape>
  Object& Add(Shape shape, Index material) {
    Object object;
    object.shape = std::move(shape);
    object.material = material;
    scene.objects.push_back(std::move(object));
    return scene.objects.back();
  }
  /// Adds a mesh of that material; a reference to its object.
  Object& Add(TriangleMesh mesh, Index material) {
    scene.meshes.push_back(std::move(mesh));
    const auto data = static_cast<Index>(scene.meshes.size()) - 1;
    return Add(Mesh{"", true, 0, data}, material);
  }
  void AddLight(decltype(Light::kind) kind) {
    Light light;
    light.kind = std::move(kind);
    scene.lights.push_back(std::move(light));
  }
  void Look(const V3d& from, const V3d& at) {
    scene.camera.position = from;
    scene.camera.direction = at - from;
    if ((at - from).cross(scene.camera.up).length() == 0) {
      scene.camera.up = V3d(0, 0, -1);
    }
  }
  void SetBackground(const Rgb& color) {
    scene.background.kind = ConstantBackground{color};
  }

  /// The radiance that a single ray through the picture's center brings, which
  /// is all that it stands for.
  Rgb Center(const RenderOptions& options = {}) const {
    SamplePlan plan = PixelPlan(1, 1);
    plan.beam = V2f(0, 0);
    return Render(plan, options).values.at(0);
  }
  /// Renders a plan; aborts on an Error.
  Fragments Render(const SamplePlan& plan,
                   const RenderOptions& options = {}) const {
    auto backend = MakeBackend("embree", scene).value();
    return backend->Render(plan, options).value();
  }

  Scene scene;
};

}  // namespace rtb::testing
