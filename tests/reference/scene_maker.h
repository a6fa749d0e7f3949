/// @file
/// Small scenes made by hand, for the tests of the exporters.
#pragma once

#include <string>
#include <utility>

#include "core/scene/scene.h"

namespace rtb {

/// Adds a material and returns its index.
inline Index AddMaterial(Scene* scene, decltype(Material::bsdf) bsdf,
                         Texture texture = {}) {
  Material material;
  material.id = "m" + std::to_string(scene->materials.size());
  material.bsdf = std::move(bsdf);
  material.texture = std::move(texture);
  material.mark = {7, 3};
  scene->materials.push_back(std::move(material));
  return static_cast<Index>(scene->materials.size()) - 1;
}

/// Adds an object at the top of the tree; the reference holds until the next.
inline Object& AddObject(Scene* scene, decltype(Object::shape) shape,
                         Index material = kNone) {
  Object object;
  object.shape = std::move(shape);
  object.material = material;
  object.mark = {9, 5};
  return scene->objects.emplace_back(std::move(object));
}

/// Adds a light.
inline void AddLight(Scene* scene, decltype(Light::kind) kind) {
  Light light;
  light.id = "l" + std::to_string(scene->lights.size());
  light.kind = std::move(kind);
  light.mark = {5, 5};
  scene->lights.push_back(std::move(light));
}

/// A scene seen from the origin along -z, 90 degrees high: the pixel at
/// (x0, y0), shares of the height from the middle, looks along (2 x0, 2 y0,
/// -1).
inline Scene MakeScene() {
  Scene scene;
  scene.name = "made";
  scene.file = "made.yaml";
  scene.camera.vfov = 90;
  return scene;
}

}  // namespace rtb
