/// @file
/// What the format has and this build does not render yet. Each case names
/// its key; the file goes when the renderer is complete.
#include <string>
#include <utility>

#include "core/scene/load.h"
#include "core/scene/yaml_tree.h"

namespace rtb {
namespace {

/// A key of the format that is not rendered; no key when all are.
struct Unrendered {
  std::string what;
  std::string hint;
};

Unrendered Of(const ConstantBackground&) { return {}; }
Unrendered Of(const GradientBackground&) { return {}; }
Unrendered Of(const ImageBackground&) {
  return {"a background of `type: image`", "use constant or gradient"};
}

Unrendered Of(const Lambertian&) { return {}; }
Unrendered Of(const Mirror&) { return {}; }
Unrendered Of(const Dielectric&) { return {}; }
Unrendered Of(const Emissive&) { return {}; }
Unrendered Of(const Metal& metal) {
  if (metal.roughness == 0) return {};
  return {"`roughness` of a metal", "use roughness: 0"};
}
Unrendered Of(const Plastic&) {
  return {"a material of `type: plastic`", "use lambertian"};
}
Unrendered Of(const Phong&) {
  return {"a material of `type: phong`", "use lambertian"};
}

Unrendered OfAdditions(const Material& material) {
  if (std::holds_alternative<ImageTexture>(material.texture)) {
    return {"a texture of `type: image`", "use albedo or a checker"};
  }
  if (material.bump) return {"`bump`", "leave it out"};
  return {};
}

Unrendered Of(const PointLight&) { return {}; }
Unrendered Of(const DirectionalLight&) { return {}; }
Unrendered Of(const SpotLight&) {
  return {"a light of `type: spot`", "use point"};
}
Unrendered Of(const QuadLight&) {
  return {"a light of `type: quad`", "use point"};
}
Unrendered Of(const SphereLight&) {
  return {"a light of `type: sphere`", "use point"};
}

Unrendered OfMesh(const Mesh& mesh, const Scene& scene) {
  if (mesh.subdivide != 0) return {"`subdivide`", "use subdivide: 0"};
  if (mesh.data == kNone) return {};
  const auto data = static_cast<std::size_t>(mesh.data);
  if (mesh.smooth && !scene.meshes[data].normals.empty()) {
    return {"`smooth` (true unless given) of a mesh with normals",
            "use smooth: false"};
  }
  return {};
}

Unrendered OfAny(const auto& kind) {
  return std::visit([](const auto& one) { return Of(one); }, kind);
}

Status Require(const Unrendered& found, const Scene& scene, SourceMark mark) {
  if (found.what.empty()) return {};
  return Fail(BadInput(PlaceOf(scene.file.string(), mark),
                       found.what + " is not rendered yet", found.hint));
}

Status CheckObjects(const std::vector<Object>& objects, const Scene& scene) {
  for (const Object& object : objects) {
    if (const auto* mesh = std::get_if<Mesh>(&object.shape)) {
      RTB_RETURN_IF_ERROR(Require(OfMesh(*mesh, scene), scene, object.mark));
    }
    RTB_RETURN_IF_ERROR(CheckObjects(object.children, scene));
  }
  return {};
}

}  // namespace

Status CheckRenderable(const Scene& scene) {
  RTB_RETURN_IF_ERROR(
      Require(OfAny(scene.background.kind), scene, scene.background.mark));
  for (const Material& material : scene.materials) {
    RTB_RETURN_IF_ERROR(Require(OfAny(material.bsdf), scene, material.mark));
    RTB_RETURN_IF_ERROR(Require(OfAdditions(material), scene, material.mark));
  }
  for (const Light& light : scene.lights) {
    RTB_RETURN_IF_ERROR(Require(OfAny(light.kind), scene, light.mark));
  }
  return CheckObjects(scene.objects, scene);
}

}  // namespace rtb
