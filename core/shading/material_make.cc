#include "core/shading/material_make.h"

#include <map>
#include <utility>

namespace rtb {
namespace {

/// Turns a material's model into plain data; textures come apart.
struct ModelConverter {
  const GgxEnergyView energy;

  MaterialData Make(SurfaceModel model, const Rgb& color, double ior = 1.5,
                    double roughness = 0) const {
    MaterialData data;
    data.bsdf = MakeBsdf(model, color, static_cast<float>(ior),
                         static_cast<float>(roughness), energy);
    return data;
  }
  MaterialData operator()(const Lambertian& m) const {
    return Make(SurfaceModel::kLambertian, m.albedo);
  }
  MaterialData operator()(const Mirror& m) const {
    return Make(SurfaceModel::kMirror, m.reflectance);
  }
  MaterialData operator()(const Metal& m) const {
    return Make(SurfaceModel::kMetal, m.albedo, 1.5, m.roughness);
  }
  MaterialData operator()(const Dielectric& m) const {
    return Make(SurfaceModel::kDielectric, m.tint, m.ior);
  }
  MaterialData operator()(const Plastic& m) const {
    return Make(SurfaceModel::kPlastic, m.albedo, m.ior, m.roughness);
  }
  MaterialData operator()(const Phong& m) const {
    MaterialData data = Make(SurfaceModel::kPhong, m.albedo);
    data.bsdf.specular = m.specular;
    data.bsdf.exponent = static_cast<float>(m.exponent);
    data.reflectance = m.reflectance;
    return data;
  }
  MaterialData operator()(const Emissive& m) const {
    return Make(SurfaceModel::kEmissive, m.radiance);
  }
};

/// Converts materials one by one; textures point to images that are read
/// first, since these must stay where they are.
class MaterialMaker {
 public:
  explicit MaterialMaker(ShadingScene* shading) : shading_(*shading) {}

  /// Reads what a material names, each file once.
  Status ReadImages(const Material& material) {
    if (const auto* t = std::get_if<ImageTexture>(&material.texture)) {
      RTB_RETURN_IF_ERROR(Read(t->file, LoadTexture, &texture_files_,
                               &shading_.texture_images));
    }
    if (material.bump) {
      RTB_RETURN_IF_ERROR(Read(material.bump->file, LoadHeightMap, &bump_files_,
                               &shading_.height_maps));
    }
    return {};
  }

  void Add(const Material& material) {
    const ModelConverter convert{ViewOf(shading_.ggx_energy)};
    MaterialData data = std::visit(convert, material.bsdf);
    V2f scale(1, 1);
    if (const auto* c = std::get_if<CheckerTexture>(&material.texture)) {
      data.checker = {c->a, c->b, static_cast<float>(c->size)};
    }
    if (const auto* t = std::get_if<ImageTexture>(&material.texture)) {
      scale = V2f(t->scale);
      data.texture = static_cast<int>(shading_.textures.size());
      shading_.textures.push_back(TextureOf(
          shading_.texture_images[texture_files_.at(t->file)], scale));
    }
    if (material.bump) {
      // The heights belong to the picture: they repeat as it does.
      data.bump = static_cast<int>(shading_.bumps.size());
      shading_.bumps.push_back(
          BumpOf(shading_.height_maps[bump_files_.at(material.bump->file)],
                 scale, static_cast<float>(material.bump->amount)));
    }
    shading_.materials.push_back(data);
  }

 private:
  using Files = std::map<std::filesystem::path, std::size_t>;

  template <class Loader, class Levels>
  static Status Read(const std::filesystem::path& file, Loader load,
                     Files* files, std::vector<Levels>* images) {
    if (!files->emplace(file, images->size()).second) return {};
    RTB_ASSIGN_OR_RETURN(const auto image, load(file));
    images->push_back(MakeMipChain(image));
    return {};
  }

  ShadingScene& shading_;
  Files texture_files_;
  Files bump_files_;
};

}  // namespace

double RoughnessOf(const Material& material) {
  if (const auto* metal = std::get_if<Metal>(&material.bsdf)) {
    return metal->roughness;
  }
  const auto* plastic = std::get_if<Plastic>(&material.bsdf);
  return plastic != nullptr ? plastic->roughness : 0;
}

Status MakeMaterials(const Scene& scene, ShadingScene* shading) {
  MaterialMaker maker(shading);
  for (const Material& m : scene.materials) {
    RTB_RETURN_IF_ERROR(maker.ReadImages(m));
  }
  for (const Material& m : scene.materials) maker.Add(m);
  return {};
}

}  // namespace rtb
