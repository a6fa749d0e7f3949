#include "reference/blender_export.h"

#include "core/scene/animation.h"
#include "core/scene/flat_scene.h"
#include "reference/blender_images.h"
#include "reference/blender_json.h"
#include "reference/blender_material.h"
#include "reference/blender_objects.h"

namespace rtb {
namespace {

using Json = nlohmann::ordered_json;

Json CameraJson(const CameraFrame& camera) {
  return {{"position", BlenderVector(camera.position)},
          {"right", BlenderVector(camera.right)},
          {"up", BlenderVector(camera.up)},
          {"forward", BlenderVector(camera.forward)},
          {"tan_half_vfov", camera.tan_half_vfov}};
}

struct BackgroundWriter {
  BlenderImages* images;

  Result<Json> operator()(const ConstantBackground& constant) const {
    return Json{{"type", "constant"}, {"color", BlenderColor(constant.color)}};
  }
  Result<Json> operator()(const GradientBackground& gradient) const {
    return Json{{"type", "gradient"},
                {"bottom", BlenderColor(gradient.bottom)},
                {"top", BlenderColor(gradient.top)}};
  }
  Result<Json> operator()(const ImageBackground& background) const {
    RTB_ASSIGN_OR_RETURN(const int image, images->Add(background.file));
    return Json{{"type", "image"}, {"image", image}};
  }
};

/// Materials that objects have; null for the others, which may be ones that
/// cannot be exported.
Result<Json> MaterialsJson(const Scene& scene, const FlatScene& flat,
                           const std::string& integrator, double scale,
                           BlenderImages* images) {
  std::vector<Json> all(scene.materials.size() + 1 + scene.lights.size());
  for (const FlatObject& object : flat.objects) {
    Json& json =
        all[static_cast<std::size_t>(BlenderMaterialIndex(scene, object))];
    if (!json.is_null()) continue;
    if (object.light != kNone) {
      json = BlenderLightMaterial(
          scene.lights[static_cast<std::size_t>(object.light)]);
      continue;
    }
    const Material material =
        object.material == kNone
            ? Material{"default", Lambertian{}, {}, {}, {}}
            : scene.materials[static_cast<std::size_t>(object.material)];
    RTB_ASSIGN_OR_RETURN(
        json, BlenderMaterial(scene, material, integrator, scale, images));
  }
  return Json(all);
}

Json LampsJson(const Scene& scene, double time, double scale) {
  Json lamps = Json::array();
  for (const Light& light : scene.lights) {
    Json lamp = BlenderLamp(light, LightOffset(scene, light, time), scale);
    if (!lamp.is_null()) lamps.push_back(std::move(lamp));
  }
  return lamps;
}

}  // namespace

Result<std::string> ExportBlender(const Scene& scene, double time,
                                  const std::string& integrator) {
  RTB_ASSIGN_OR_RETURN(FlatScene flat, Flatten(scene, time));
  RTB_RETURN_IF_ERROR(AddLightShapes(scene, time, FlatPart::kAll, &flat));
  const double scale = BlenderScale(scene, flat);
  ScaleScene(scale, &flat);
  CameraFrame camera = CameraAt(scene, time);
  camera.position *= scale;
  BlenderImages images;
  Json json = {{"rtbench_blender", 1},
               {"name", scene.name},
               {"time", time},
               {"scale", scale},
               {"integrator", integrator},
               {"max_depth", scene.settings.max_depth}};
  // The path integrator has no ambient light.
  json["ambient"] =
      BlenderColor(integrator == "whitted" ? scene.settings.ambient : Rgb(0));
  json["camera"] = CameraJson(camera);
  RTB_ASSIGN_OR_RETURN(json["background"], std::visit(BackgroundWriter{&images},
                                                      scene.background.kind));
  RTB_ASSIGN_OR_RETURN(json["materials"],
                       MaterialsJson(scene, flat, integrator, scale, &images));
  json["images"] = images.Take();
  json["lamps"] = LampsJson(scene, time, scale);
  json.update(BlenderObjects(scene, flat, camera.position));
  return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) +
         "\n";
}

}  // namespace rtb
