#include "core/render/traced_scene.h"

#include "core/scene/flat_scene.h"

namespace rtb {
namespace {

/// One part of the scene, the lights' shapes included.
Result<FlatScene> FlattenPart(const Scene& scene, double time, FlatPart part) {
  RTB_ASSIGN_OR_RETURN(FlatScene flat, Flatten(scene, time, part));
  RTB_RETURN_IF_ERROR(AddLightShapes(scene, time, part, &flat));
  return flat;
}

}  // namespace

Result<SceneParts> PrepareParts(const Scene& scene, double time) {
  SceneParts parts;
  RTB_ASSIGN_OR_RETURN(const FlatScene still,
                       FlattenPart(scene, time, FlatPart::kStill));
  parts.geometry = MakeGeometry(still, scene.meshes);
  RTB_ASSIGN_OR_RETURN(parts.shading, MakeShadingScene(scene));
  RTB_RETURN_IF_ERROR(MoveParts(scene, time, &parts));
  return parts;
}

Status MoveParts(const Scene& scene, double time, SceneParts* parts) {
  RTB_ASSIGN_OR_RETURN(const FlatScene moving,
                       FlattenPart(scene, time, FlatPart::kMoving));
  ReplaceMoving(moving, &parts->geometry);
  PlaceLights(scene, time, parts->geometry, &parts->shading);
  return {};
}

std::vector<Rgb> Transmittances(const SceneParts& parts) {
  const ShadingView shading = ViewOf(parts.shading);
  std::vector<Rgb> transmittance;
  transmittance.reserve(parts.geometry.objects.size());
  for (const ObjectData& object : parts.geometry.objects) {
    const bool is_light = object.light >= 0;
    transmittance.push_back(
        is_light ? Rgb(0)
                 : ShadowTransmittance(shading.material(object.material)));
  }
  return transmittance;
}

}  // namespace rtb
