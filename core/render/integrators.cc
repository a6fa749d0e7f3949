#include "core/render/integrators.h"

#include "core/scene/yaml_tree.h"

namespace rtb {

Status CheckIntegrator(const Scene& scene, const RenderOptions& options) {
  if (options.integrator == "whitted") return {};
  if (options.integrator != "path") {
    return Fail(BadInput("--integrator",
                         "unknown integrator `" + options.integrator + "`",
                         kIntegrators));
  }
  for (const Material& material : scene.materials) {
    if (!std::holds_alternative<Phong>(material.bsdf)) continue;
    return Fail(BadInput(
        PlaceOf(scene.file.string(), material.mark),
        "the path integrator cannot render a material of `type: phong`",
        "take --integrator=whitted, or `type: plastic` in its stead"));
  }
  return {};
}

}  // namespace rtb
