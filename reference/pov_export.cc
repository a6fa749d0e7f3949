#include "reference/pov_export.h"

#include "core/base/check.h"
#include "core/scene/animation.h"
#include "core/scene/flat_scene.h"
#include "reference/pov_geometry.h"
#include "reference/pov_glass.h"
#include "reference/pov_light.h"
#include "reference/pov_material.h"
#include "reference/pov_text.h"

namespace rtb {
namespace {

Error CannotExpress(const Scene& scene, const SourceMark& mark,
                    const std::string& what) {
  return BadInput(PlaceOf(scene, mark), "POV-Ray cannot express " + what,
                  "use another reference, e.g. --reference=self");
}

/// What of a mesh is missing in the FlatScene; empty = nothing.
std::string MissingOf(const Scene& scene, const Mesh& mesh) {
  if (mesh.subdivide != 0) return "`subdivide`, which it does not have";
  if (!mesh.smooth || mesh.data == kNone) return "";
  const auto& data = scene.meshes[static_cast<std::size_t>(mesh.data)];
  return data.normals.empty() ? ""
                              : "`smooth: true` of a mesh with normals as ours";
}

/// Refuses what of the meshes at and below an object is not exported.
Status CheckMeshes(const Scene& scene, const Object& object) {
  if (const auto* mesh = std::get_if<Mesh>(&object.shape)) {
    const std::string missing = MissingOf(scene, *mesh);
    if (!missing.empty()) {
      return Fail(CannotExpress(scene, object.mark, missing));
    }
  }
  for (const Object& child : object.children) {
    RTB_RETURN_IF_ERROR(CheckMeshes(scene, child));
  }
  return {};
}

Status CheckExpressible(const Scene& scene, const FlatScene& flat) {
  for (const FlatObject& object : flat.objects) {
    if (object.material == kNone) continue;
    RTB_RETURN_IF_ERROR(CheckPovMaterial(
        scene, scene.materials[static_cast<std::size_t>(object.material)]));
  }
  for (const Light& light : scene.lights) {
    RTB_RETURN_IF_ERROR(CheckPovLight(scene, light));
  }
  for (const Object& object : scene.objects) {
    RTB_RETURN_IF_ERROR(CheckMeshes(scene, object));
  }
  if (std::holds_alternative<ImageBackground>(scene.background.kind)) {
    return Fail(CannotExpress(scene, scene.background.mark,
                              "an image `background` filtered as ours"));
  }
  return CheckPovGlass(scene, flat);
}

/// One ray more than the bounces: POV-Ray counts the eye ray too, and a ray
/// past the limit is black there as well.
std::string Header(const Scene& scene) {
  return "#version 3.7;\n"
         "global_settings { assumed_gamma 1.0 ambient_light rgb 0 "
         "max_trace_level " +
         std::to_string(scene.settings.max_depth + 1) +
         " adc_bailout 0 }\n"
         "#default { finish { ambient rgb 0 emission rgb 0 diffuse 0 "
         "specular 0 phong 0 brilliance 1 } }\n";
}

/// The rows BandBegin <= row < BandEnd of a picture of BandRows rows fill the
/// image, so that a picture can be rendered in bands. These come from the
/// command line as integers: there POV-Ray keeps single precision only.
std::string CameraText(const CameraFrame& camera, double scale) {
  const double side = 2 * camera.tan_half_vfov;
  const std::string up = PovVector(camera.up * side);
  return "#ifndef (BandRows)\n"
         "  #declare BandRows = 1; #declare BandBegin = 0; "
         "#declare BandEnd = 1;\n"
         "#end\n"
         "#declare Share = (BandEnd - BandBegin) / BandRows;\n"
         "#declare Middle = (BandBegin + BandEnd) / (2 * BandRows);\n"
         "camera {\n  perspective\n  location " +
         PovVector(camera.position * scale) + "\n  right " +
         PovVector(camera.right * side) +
         " * (Share * image_width / image_height)\n  up " + up +
         " * Share\n  direction " + PovVector(camera.forward) + " + " + up +
         " * (0.5 - Middle)\n}\n";
}

struct BackgroundWriter {
  std::string operator()(const ConstantBackground& constant) const {
    return "background { " + PovColor(constant.color) + " }\n";
  }
  std::string operator()(const GradientBackground& gradient) const {
    // Kept away from 0 and 1, where a function's value would wrap around.
    return "sky_sphere { pigment { function { 0.25 * (y + 2) } color_map { "
           "[0.25 " +
           PovColor(gradient.bottom) + "] [0.75 " + PovColor(gradient.top) +
           "] } } }\n";
  }
  std::string operator()(const ImageBackground&) const {
    RTB_CHECK(!"a background that CheckExpressible refuses");
    return "";
  }
};

}  // namespace

Result<std::string> ExportPov(const Scene& scene, double time) {
  RTB_ASSIGN_OR_RETURN(FlatScene flat, Flatten(scene, time));
  RTB_RETURN_IF_ERROR(ExpandMeshes(scene, &flat));
  RTB_RETURN_IF_ERROR(CheckExpressible(scene, flat));
  const CameraFrame camera = CameraAt(scene, time);
  const double scale = PovScale(flat, camera.position);
  std::string text = "// Scene `" + scene.name + "` at " + PovNumber(time) +
                     " s, lengths times " + PovNumber(scale) + "\n" +
                     Header(scene) + CameraText(camera, scale) +
                     std::visit(BackgroundWriter{}, scene.background.kind);
  for (const Light& light : scene.lights) {
    text += PovLight(scene, light, time, scale);
  }
  return text + PovGeometry(scene, flat, scale);
}

}  // namespace rtb
