#include "core/render/wide/wide_scene.h"

#include <cmath>

#include "core/accel/surface.h"
#include "core/shading/bsdf.h"

namespace rtb {
namespace {

using Model = WideScene::Model;

void Put(const V3f& v, std::size_t column, WideScene::Rows* rows) {
  for (int axis = 0; axis < 3; ++axis) (*rows)[axis][column] = v[axis];
}

std::optional<Model> ModelOf(const MaterialData& material) {
  if (material.checker.size > 0 || material.texture >= 0 ||
      material.bump >= 0) {
    return {};
  }
  switch (material.bsdf.model) {
    case SurfaceModel::kLambertian:
      return Model::kLambertian;
    case SurfaceModel::kMirror:
      return Model::kMirror;
    case SurfaceModel::kMetal:
      return material.bsdf.alpha > 0 ? Model::kRough : Model::kSmooth;
    case SurfaceModel::kDielectric:
      return Model::kGlass;
    default:
      return {};
  }
}

/// Fills a WideScene's columns one by one.
class WideSceneMaker {
 public:
  WideSceneMaker(const Geometry& geometry, const ShadingView& shading)
      : geometry_(geometry), shading_(shading) {}

  std::optional<WideScene> Make() {
    const Geometry& g = geometry_;
    if (!g.triangle_objects.empty() || !g.uses.empty()) return {};
    if (shading_.light_count > 0 || shading_.unsampled_emitters) return {};
    if (shading_.background.image.texels != nullptr) return {};
    if (g.planes.size() + g.spheres.size() + g.disks.size() >
        WideScene::kMost) {
      return {};
    }
    if (!AddPlanes() || !AddSpheres() || !AddDisks()) return {};
    scene_.sky = shading_.background;
    scene_.sky_chance = DiscreteProbability(shading_.light_cdf, 0);
    scene_.energy = shading_.ggx_energy;
    return scene_;
  }

 private:
  std::size_t Column() const {
    return static_cast<std::size_t>(scene_.count());
  }

  bool AddPlanes() {
    for (const PlaneData& plane : geometry_.planes) {
      Put(plane.point, Column(), &scene_.center);
      Put(plane.normal, Column(), &scene_.normal);
      scene_.scale[Column()] = MaxAbs(plane.point);
      if (!AddMaterial(plane.object)) return false;
      ++scene_.planes;
    }
    return true;
  }
  bool AddSpheres() {
    for (const Quadric& sphere : geometry_.spheres) {
      if (!AddQuadric(sphere)) return false;
      ++scene_.spheres;
    }
    return true;
  }
  bool AddDisks() {
    for (const Quadric& disk : geometry_.disks) {
      Put(NormalToWorld(disk.to_unit, V3f(0, 0, 1)), Column(), &scene_.normal);
      if (!AddQuadric(disk)) return false;
      ++scene_.disks;
    }
    return true;
  }

  bool AddQuadric(const Quadric& quadric) {
    Put(quadric.center, Column(), &scene_.center);
    const Affinef* maps[] = {&quadric.to_unit, &quadric.to_world};
    WideScene::Rows* rows[] = {scene_.to_unit, scene_.to_world};
    for (int i = 0; i < 2; ++i) {
      Put(maps[i]->x, Column(), &rows[i][0]);
      Put(maps[i]->y, Column(), &rows[i][1]);
      Put(maps[i]->z, Column(), &rows[i][2]);
    }
    scene_.scale[Column()] = quadric.scale;
    return AddMaterial(quadric.object);
  }

  bool AddMaterial(int object_index) {
    const std::size_t i = Column();
    const ObjectData& object =
        geometry_.objects[static_cast<std::size_t>(object_index)];
    if (object.light >= 0) return false;
    const MaterialData& material = shading_.material(object.material);
    const std::optional<Model> model = ModelOf(material);
    if (!model) return false;
    const BsdfData& bsdf = material.bsdf;
    scene_.has[*model] = true;
    scene_.model[i] = static_cast<float>(*model);
    Put(bsdf.color, i, &scene_.color);
    Put(bsdf.color / kPi, i, &scene_.diffuse);
    scene_.inside[i] = bsdf.ior;
    scene_.outside[i] = 1 / bsdf.ior;
    if (*model == Model::kRough) AddRough(bsdf, i);
    return true;
  }

  void AddRough(const BsdfData& bsdf, std::size_t i) {
    const Rgb further = FurtherShare(bsdf);
    scene_.alpha[i] = bsdf.alpha;
    Put(MeanSpecularFresnel(bsdf) * further, i, &scene_.compensation);
    scene_.further[i] = MaxComponent(further);
    scene_.mean_loss[i] = kPi * bsdf.average_loss;
    scene_.log_range[i] = std::log1p(1 / bsdf.alpha);
  }

  const Geometry& geometry_;
  const ShadingView& shading_;
  WideScene scene_;
};

}  // namespace

std::optional<WideScene> MakeWideScene(const Geometry& geometry,
                                       const ShadingView& shading) {
  return WideSceneMaker(geometry, shading).Make();
}

}  // namespace rtb
