#include "reference/blender_material.h"

#include "core/base/check.h"
#include "reference/blender_json.h"
#include "reference/pov_material.h"

namespace rtb {
namespace {

using Json = nlohmann::ordered_json;

/// The keys of a material's own kind.
struct MaterialWriter {
  Json operator()(const Lambertian& m) const {
    return {{"type", "lambertian"}, {"color", BlenderColor(m.albedo)}};
  }
  Json operator()(const Mirror& m) const {
    return {{"type", "mirror"}, {"color", BlenderColor(m.reflectance)}};
  }
  Json operator()(const Metal& m) const {
    return {{"type", "metal"},
            {"color", BlenderColor(m.albedo)},
            {"roughness", m.roughness}};
  }
  Json operator()(const Dielectric& m) const {
    return {{"type", "dielectric"},
            {"color", BlenderColor(m.tint)},
            {"ior", m.ior}};
  }
  Json operator()(const Emissive& m) const {
    return {{"type", "emissive"}, {"color", BlenderColor(m.radiance)}};
  }
  Json operator()(const Plastic&) const { return Refused(); }
  Json operator()(const Phong&) const { return Refused(); }

 private:
  static Json Refused() {
    RTB_CHECK(!"a material that Inexpressible names");
    return {};
  }
};

/// What of a material Cycles has no counterpart for; empty = nothing.
std::string Inexpressible(const Material& material,
                          const std::string& integrator) {
  if (material.bump && !std::holds_alternative<Lambertian>(material.bsdf)) {
    return "`bump` of another `type` than lambertian";
  }
  if (std::holds_alternative<Plastic>(material.bsdf)) return "`type: plastic`";
  if (std::holds_alternative<Phong>(material.bsdf)) return "`type: phong`";
  const bool textured =
      !std::holds_alternative<std::monostate>(material.texture);
  if (textured && std::holds_alternative<Dielectric>(material.bsdf)) {
    return "`texture` on a dielectric";
  }
  const auto* metal = std::get_if<Metal>(&material.bsdf);
  if (metal && metal->roughness > 0 && integrator == "whitted") {
    return "the whitted integrator's rays at `roughness` of a metal";
  }
  return "";
}

struct TextureWriter {
  BlenderImages* images;

  Result<Json> operator()(const std::monostate&) const { return Json(); }
  Result<Json> operator()(const CheckerTexture& checker) const {
    return Json{{"type", "checker"},
                {"a", BlenderColor(checker.a)},
                {"b", BlenderColor(checker.b)},
                {"size", checker.size}};
  }
  Result<Json> operator()(const ImageTexture& texture) const {
    RTB_ASSIGN_OR_RETURN(const int image, images->Add(texture.file));
    return Json{{"type", "image"},
                {"image", image},
                {"scale", {texture.scale.x, texture.scale.y}}};
  }
};

/// A bump map lies as the material's texture does.
Result<Json> BumpJson(const Material& material, double scale,
                      BlenderImages* images) {
  const auto* texture = std::get_if<ImageTexture>(&material.texture);
  const V2d repeat = texture ? texture->scale : V2d(1, 1);
  RTB_ASSIGN_OR_RETURN(const int image,
                       images->AddHeights(material.bump->file));
  return Json{{"image", image},
              {"scale", {repeat.x, repeat.y}},
              {"amount", material.bump->amount * scale}};
}

/// Lamps: lights without a shape.
struct LampWriter {
  const V3d& offset;
  double scale;

  Json At(const V3d& position) const {
    return BlenderVector((position + offset) * scale);
  }
  /// An intensity that gives the same irradiance in the scaled world.
  Json Scaled(const Rgb& intensity) const {
    return BlenderColor(intensity * static_cast<float>(scale * scale));
  }

  Json operator()(const PointLight& light) const {
    return {{"type", "point"},
            {"position", At(light.position)},
            {"intensity", light.inverse_square ? Scaled(light.intensity)
                                               : BlenderColor(light.intensity)},
            {"inverse_square", light.inverse_square}};
  }
  Json operator()(const DirectionalLight& light) const {
    return {{"type", "directional"},
            {"direction", BlenderVector(light.direction.normalized())},
            {"irradiance", BlenderColor(light.irradiance)}};
  }
  Json operator()(const SpotLight& light) const {
    return {{"type", "spot"},
            {"position", At(light.position)},
            {"direction", BlenderVector(light.direction.normalized())},
            {"intensity", Scaled(light.intensity)},
            {"cone", light.cone},
            {"penumbra", light.penumbra}};
  }
  Json operator()(const QuadLight&) const { return {}; }
  Json operator()(const SphereLight&) const { return {}; }
};

struct RadianceOf {
  Rgb operator()(const QuadLight& light) const { return light.radiance; }
  Rgb operator()(const SphereLight& light) const { return light.radiance; }
  template <class Lamp>
  Rgb operator()(const Lamp&) const {
    RTB_CHECK(!"a light without a shape");
    return Rgb(0);
  }
};

}  // namespace

Result<Json> BlenderMaterial(const Scene& scene, const Material& material,
                             const std::string& integrator, double scale,
                             BlenderImages* images) {
  const std::string what = Inexpressible(material, integrator);
  if (!what.empty()) {
    return Fail(BadInput(PlaceOf(scene, material.mark),
                         "Cycles cannot express " + what +
                             " as the format means it (material `" +
                             material.id + "`)",
                         "use another reference, e.g. --reference=self"));
  }
  Json json = {{"id", material.id}};
  json.update(std::visit(MaterialWriter{}, material.bsdf));
  RTB_ASSIGN_OR_RETURN(const Json texture,
                       std::visit(TextureWriter{images}, material.texture));
  if (!texture.is_null()) json["texture"] = texture;
  if (material.bump) {
    RTB_ASSIGN_OR_RETURN(json["bump"], BumpJson(material, scale, images));
  }
  return json;
}

Json BlenderLamp(const Light& light, const V3d& offset, double scale) {
  Json json = std::visit(LampWriter{offset, scale}, light.kind);
  if (!json.is_null()) json["id"] = light.id;
  return json;
}

Json BlenderLightMaterial(const Light& light) {
  return {{"id", light.id},
          {"type", "light"},
          {"color", BlenderColor(std::visit(RadianceOf{}, light.kind))}};
}

}  // namespace rtb
