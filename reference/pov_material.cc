#include "reference/pov_material.h"

#include "core/base/check.h"
#include "reference/pov_text.h"

namespace rtb {
namespace {

/// How far along the normal the format moves a checker's hit point, in cells.
constexpr double kCheckerMove = 0.001;

/// POV-Ray passes an index of exactly 1 straight through without counting a
/// level of recursion; the least larger index is refracted and counted.
constexpr double kLeastIor = 1.000001;

std::string Texture(const std::string& pigment, const std::string& finish) {
  return "texture { pigment { " + pigment + " } finish { " + finish + " } }";
}

/// Writes a material's texture, `color` standing for its albedo where given.
struct TextureWriter {
  const Rgb& ambient;
  const Rgb* color;

  const Rgb& Or(const Rgb& own) const { return color ? *color : own; }

  /// Ambient light is albedo * ambient: emission, which POV-Ray multiplies by
  /// the pigment.
  std::string Diffuse() const {
    return ambient == Rgb(0) ? "diffuse 1"
                             : "diffuse 1 emission " + PovColor(ambient);
  }

  std::string operator()(const Lambertian& m) const {
    return Texture(PovColor(Or(m.albedo)), Diffuse());
  }
  std::string operator()(const Mirror& m) const {
    return Texture("rgb 0",
                   "reflection { " + PovColor(Or(m.reflectance)) + " }");
  }
  std::string operator()(const Metal& m) const {
    // a + (b - a) (1 - cos)^falloff is Schlick's Fresnel term.
    return Texture("rgb 0", "reflection { " + PovColor(Or(m.albedo)) +
                                ", rgb 1 falloff 5 }");
  }
  std::string operator()(const Dielectric& m) const {
    // `filter` 1 multiplies by the pigment what passes each surface, for rays
    // of sight and of shadow.
    const std::string tint = PovVector(m.tint);
    return Texture("rgbf <" + tint.substr(1, tint.size() - 2) + ", 1>",
                   "reflection { rgb 0, rgb 1 fresnel on } conserve_energy");
  }
  std::string operator()(const Phong& m) const {
    return Texture(PovColor(Or(m.albedo)),
                   Diffuse() + " phong " + PovNumber(m.specular.x) +
                       " phong_size " + PovNumber(m.exponent) +
                       " reflection { " + PovColor(m.reflectance) + " }");
  }
  std::string operator()(const Emissive& m) const {
    return Texture(PovColor(Or(m.radiance)), "emission rgb 1");
  }
  std::string operator()(const Plastic&) const {
    RTB_CHECK(!"a material that CheckPovMaterial refuses");
    return "";
  }
};

std::string CheckerText(const Material& material, const CheckerTexture& checker,
                        const Rgb& ambient, const Affined& object_to_world,
                        const PatternPlacement& placement) {
  const auto body = [&](const Rgb& color) {
    return std::visit(TextureWriter{ambient, &color}, material.bsdf);
  };
  return "texture { checker " + body(checker.a) + " " + body(checker.b) +
         " scale " + PovNumber(placement.unit) + " translate " +
         PovVector(placement.offset) + " " + PovMatrix(object_to_world) + " }";
}

/// What of a material POV-Ray has no counterpart for; empty = nothing.
struct Inexpressible {
  const Material& material;

  std::string operator()(const Metal& m) const {
    return m.roughness > 0 ? "`roughness` of a metal (GGX)" : "";
  }
  std::string operator()(const Dielectric&) const {
    const bool textured =
        !std::holds_alternative<std::monostate>(material.texture);
    return textured ? "`texture` on a dielectric" : "";
  }
  std::string operator()(const Plastic&) const { return "`type: plastic`"; }
  std::string operator()(const Phong& m) const {
    // POV-Ray's highlight has the light's color.
    const bool gray =
        m.specular.x == m.specular.y && m.specular.y == m.specular.z;
    return gray ? "" : "a colored `specular` of phong";
  }
  template <class Other>
  std::string operator()(const Other&) const {
    return "";
  }
};

}  // namespace

PatternPlacement CheckerOnFlat(double size, const V3d& object_normal) {
  // p/size + move * n = (p + size * move * n) / size
  return {size, object_normal * (-size * kCheckerMove)};
}

PatternPlacement CheckerOnSphere(double size, const V3d& center,
                                 double radius) {
  // p/size + move * (p - c)/r = (p - move * unit/r * c) / unit
  const double unit = 1 / (1 / size + kCheckerMove / radius);
  return {unit, center * (kCheckerMove * unit / radius)};
}

const CheckerTexture* CheckerOf(const Material* material) {
  return material ? std::get_if<CheckerTexture>(&material->texture) : nullptr;
}

std::string PovMaterial(const Material* material, const Rgb& ambient,
                        const Affined& object_to_world,
                        const PatternPlacement& placement) {
  if (material == nullptr) {
    return TextureWriter{ambient, nullptr}(Lambertian{});
  }
  if (const CheckerTexture* checker = CheckerOf(material)) {
    return CheckerText(*material, *checker, ambient, object_to_world,
                       placement);
  }
  std::string text =
      std::visit(TextureWriter{ambient, nullptr}, material->bsdf);
  if (const auto* glass = std::get_if<Dielectric>(&material->bsdf)) {
    text +=
        " interior { ior " + PovNumber(std::max(glass->ior, kLeastIor)) + " }";
  }
  return text;
}

Status CheckPovMaterial(const Scene& scene, const Material& material) {
  std::string what = std::visit(Inexpressible{material}, material.bsdf);
  if (std::holds_alternative<ImageTexture>(material.texture)) {
    what = "an image `texture`";
  }
  if (material.bump) what = "`bump`";
  if (what.empty()) return {};
  return Fail(BadInput(PlaceOf(scene, material.mark),
                       "POV-Ray cannot express " + what +
                           " as the format "
                           "means it (material `" +
                           material.id + "`)",
                       "use another reference, e.g. --reference=self"));
}

std::string PlaceOf(const Scene& scene, const SourceMark& mark) {
  return scene.file.string() + ":" + std::to_string(mark.line) + ":" +
         std::to_string(mark.column);
}

}  // namespace rtb
