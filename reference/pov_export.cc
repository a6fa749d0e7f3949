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

Status CheckExpressible(const Scene& scene, const FlatScene& flat) {
  for (const FlatObject& object : flat.objects) {
    if (object.material == kNone) continue;
    RTB_RETURN_IF_ERROR(CheckPovMaterial(
        scene, scene.materials[static_cast<std::size_t>(object.material)]));
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

/// Rays go through the center of the cell (PassRow, PassColumn) of a grid of
/// PassSide x PassSide in each pixel, so that a picture can be rendered in
/// passes. These come from the command line as integers: there POV-Ray keeps
/// single precision only.
std::string CameraText(const CameraFrame& camera, double scale) {
  const double side = 2 * camera.tan_half_vfov;
  return "#ifndef (PassSide)\n"
         "  #declare PassSide = 1; #declare PassRow = 0; "
         "#declare PassColumn = 0;\n"
         "#end\n"
         "#declare Right = " +
         PovVector(camera.right * side) +
         " * (image_width / image_height);\n"
         "#declare Up = " +
         PovVector(camera.up * side) +
         ";\n"
         "camera {\n  perspective\n  location " +
         PovVector(camera.position * scale) +
         "\n  right Right\n  up Up\n  direction " + PovVector(camera.forward) +
         "\n    + Right * (((PassColumn + 0.5) / PassSide - 0.5) / "
         "image_width)\n"
         "    - Up * (((PassRow + 0.5) / PassSide - 0.5) / image_height)\n"
         "}\n";
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
  const std::string text =
      "// Scene `" + scene.name + "` at " + PovNumber(time) +
      " s, lengths times " + PovNumber(scale) + "\n" + Header(scene) +
      CameraText(camera, scale) +
      std::visit(BackgroundWriter{}, scene.background.kind);
  return text + PovLights(scene, time, scale) + PovGeometry(scene, flat, scale);
}

}  // namespace rtb
