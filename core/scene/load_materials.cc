/// @file
/// Materials and their textures.
#include <array>

#include "core/scene/scene_reader.h"

namespace rtb {
namespace {

using Bsdf = decltype(Material::bsdf);

/// What stands under the key `albedo`, unless a texture stands in its place.
/// @param texture whether the material has one.
Rgb ReadAlbedo(MapReader& reader, bool texture) {
  if (!texture) return reader.Color("albedo", kUnitRange);
  if (reader.Has("albedo")) {
    reader.context().Fail(reader.MarkOf("albedo"),
                          "the material has both `albedo` and `texture`, "
                          "expected one of them",
                          "the texture stands in place of the albedo");
  }
  return Rgb(1, 1, 1);
}

Bsdf ReadLambertian(MapReader& reader, bool texture) {
  return Lambertian{ReadAlbedo(reader, texture)};
}
Bsdf ReadMetal(MapReader& reader, bool texture) {
  const Rgb albedo = ReadAlbedo(reader, texture);
  return Metal{albedo, reader.Number("roughness", kUnitRange, 0)};
}
Bsdf ReadPlastic(MapReader& reader, bool texture) {
  Plastic plastic;
  plastic.albedo = ReadAlbedo(reader, texture);
  plastic.ior = reader.Number("ior", kIor);
  plastic.roughness = reader.Number("roughness", kUnitRange, 0);
  return plastic;
}
Bsdf ReadPhong(MapReader& reader, bool texture) {
  Phong phong;
  phong.albedo = ReadAlbedo(reader, texture);
  phong.specular = reader.Color("specular", kUnitRange);
  phong.exponent = reader.Number("exponent", kPositive);
  phong.reflectance = reader.Color("reflectance", kUnitRange, Rgb(0, 0, 0));
  return phong;
}
Bsdf ReadMirror(MapReader& reader, bool) {
  return Mirror{reader.Color("reflectance", kUnitRange, Rgb(1, 1, 1))};
}
Bsdf ReadDielectric(MapReader& reader, bool) {
  const double ior = reader.Number("ior", kIor);
  return Dielectric{ior, reader.Color("tint", kUnitRange, Rgb(1, 1, 1))};
}
Bsdf ReadEmissive(MapReader& reader, bool) {
  return Emissive{reader.Color("radiance", kNonNegative)};
}

/// One kind of material: how it is read, and what may be added to it.
struct Kind {
  Bsdf (*read)(MapReader&, bool);
  bool has_albedo;  ///< So that a texture may stand in its place.
  bool has_bump;
};

/// The kinds, in the order of kNames.
constexpr std::array<Kind, 7> kKinds = {{
    {ReadLambertian, true, true},
    {ReadMirror, false, true},
    {ReadMetal, true, true},
    {ReadDielectric, false, true},
    {ReadPlastic, true, true},
    {ReadPhong, true, true},
    {ReadEmissive, false, false},
}};
const std::array<std::string, 7> kNames = {"lambertian", "mirror",  "metal",
                                           "dielectric", "plastic", "phong",
                                           "emissive"};

}  // namespace

void SceneReader::ReadMaterials(MapReader& root) {
  for (const YamlNode& node : Section(root, "materials")) {
    ReadMaterial(node);
    if (!context_.ok()) return;
  }
}

void SceneReader::ReadMaterial(YamlNode node) {
  MapReader reader(node, "a material", context_);
  Material material;
  material.mark = reader.mark();
  material.id = reader.Name("id");
  const std::size_t type = reader.Type(kNames);
  if (!context_.ok()) return;
  const Kind& kind = kKinds[type];
  reader.set_owner("a material of type " + kNames[type]);
  if (kind.has_albedo) material.texture = ReadTexture(reader);
  if (kind.has_bump) ReadBump(reader, &material);
  const bool textured =
      !std::holds_alternative<std::monostate>(material.texture);
  material.bsdf = kind.read(reader, textured);
  AddId(reader, material.id, static_cast<Index>(scene_.materials.size()),
        &material_ids_);
  reader.Finish();
  if (context_.ok()) scene_.materials.push_back(std::move(material));
}

Texture SceneReader::ReadTexture(MapReader& material) {
  static const std::array<std::string, 2> kTypes = {"checker", "image"};
  auto reader = material.FindMap("texture", "a texture");
  if (!reader) return std::monostate();
  const std::size_t type = reader->Type(kTypes);
  if (!context_.ok()) return std::monostate();
  Texture texture;
  if (type == 0) {
    const Rgb a = reader->Color("a", kUnitRange);
    const Rgb b = reader->Color("b", kUnitRange);
    texture = CheckerTexture{a, b, reader->Number("size", kPositive)};
  } else {
    const V2d scale = reader->Pair("scale", V2d(1, 1));
    texture = ImageTexture{File(*reader), scale};
  }
  reader->Finish();
  return texture;
}

void SceneReader::ReadBump(MapReader& material, Material* result) {
  auto reader = material.FindMap("bump", "a bump map");
  if (!reader) return;
  const double amount = reader->Number("amount", kAnyNumber);
  result->bump = BumpMap{File(*reader), amount};
  reader->Finish();
}

}  // namespace rtb
