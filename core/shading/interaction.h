/// @file
/// Interaction: a surface hit made ready for shading - textures looked up,
/// normals turned, the BSDF in a frame. Host and device.
#pragma once

#include "core/accel/surface.h"
#include "core/accel/surface_uv.h"
#include "core/base/host_device.h"
#include "core/math/frame.h"
#include "core/shading/bsdf.h"
#include "core/shading/bump.h"
#include "core/shading/light.h"
#include "core/shading/ray_cone.h"
#include "core/shading/shading_scene.h"
#include "core/shading/texture.h"

namespace rtb {

/// What light from a direction becomes: f |cos|, and the density with which
/// Sample would have chosen that direction.
struct Scattered {
  Rgb value{0};
  float pdf = 0;
};

/// Where a path goes on.
struct Bounce {
  V3f direction{0};  ///< Unit, in the world.
  Rgb weight{0};     ///< f |cos| / pdf.
  float pdf = 0;     ///< Per solid angle; 0 when `delta`.
  bool delta = false;
};

/// A point of a surface as a viewer sees it.
struct Interaction {
  SurfacePoint point;
  V3f outgoing{0};   ///< Unit, towards the viewer.
  V3f geometric{0};  ///< Unit geometric normal on the viewer's side.
  V3f normal{0};     ///< Unit shading normal on the viewer's side.
  bool from_outside = true;
  BsdfData bsdf;
  Rgb emitted{0};         ///< Radiance towards the viewer.
  bool is_light = false;  ///< It is the shape of one of the scene's lights.
  Rgb reflectance{0};     ///< Phong's.
  RayCone cone;           ///< The beam that goes on from here.

  /// The direction in the BSDF's frame, whose +z is the shading normal: on the
  /// viewer's side, but outward for a dielectric.
  RTB_HD V3f ToLocal(const V3f& v) const {
    return V3f(v.dot(frame_.s), v.dot(frame_.t), v.dot(axis_));
  }
  RTB_HD V3f ToWorld(const V3f& v) const {
    return (frame_.s * v.x + frame_.t * v.y + axis_ * v.z).normalized();
  }
  RTB_HD void SetFrame() {
    const bool inward =
        bsdf.model == SurfaceModel::kDielectric && !from_outside;
    axis_ = inward ? -normal : normal;
    frame_ = TangentsOf(axis_);
  }

  /// f |cos| for light from a unit direction, by all but delta parts; nothing
  /// comes through from behind the geometric surface (Veach 1997, section
  /// 5.3).
  RTB_HD Rgb Evaluate(const GgxEnergyView& energy, const V3f& towards) const {
    if (!(towards.dot(geometric) > 0)) return Rgb(0);
    const V3f wi = ToLocal(towards);
    if (!(wi.z > 0)) return Rgb(0);
    return EvalBsdf(bsdf, energy, ToLocal(outgoing), wi) * wi.z;
  }

  /// The same with the density of Sample.
  RTB_HD Scattered EvaluateWithPdf(const GgxEnergyView& energy,
                                   const V3f& towards) const {
    Scattered result;
    result.value = Evaluate(energy, towards);
    if (result.value == Rgb(0)) return result;
    result.pdf = PdfBsdf(bsdf, energy, ToLocal(outgoing), ToLocal(towards));
    return result;
  }

  /// A direction chosen by the BSDF for three uniforms.
  RTB_HD Bounce Sample(const GgxEnergyView& energy, const V3f& u) const {
    const BsdfSample sample = SampleBsdf(bsdf, energy, ToLocal(outgoing), u);
    if (sample.weight == Rgb(0)) return {};
    Bounce bounce{ToWorld(sample.wi), sample.weight, sample.pdf, sample.delta};
    if (sample.transmitted) return bounce;
    if (sample.delta) {
      bounce.direction = AboveSurface(bounce.direction);
    } else if (!(bounce.direction.dot(geometric) > 0)) {
      return {};
    }
    return bounce;
  }

  /// A mirror direction that an interpolated normal sends below the geometric
  /// surface is mirrored once more, at that surface.
  RTB_HD V3f AboveSurface(const V3f& direction) const {
    const float above = direction.dot(geometric);
    return above < 0 ? direction - geometric * (2 * above) : direction;
  }

 private:
  V3f axis_{0};
  Tangents<float> frame_{V3f(0), V3f(0)};
};

/// The checker's color, which lives in the object's own coordinates.
RTB_HD inline Rgb ObjectCheckerColor(const CheckerData& checker,
                                     const ObjectData& object,
                                     const SurfacePoint& point) {
  const Affinef& map = object.world_to_object;
  // A world-to-object map takes normals there by its inverse transpose;
  // the cofactors of the linear part give that without inverting.
  const V3f normal = map.y.cross(map.z) * point.normal.x +
                     map.z.cross(map.x) * point.normal.y +
                     map.x.cross(map.y) * point.normal.z;
  return CheckerColor(checker, map.Point(point.position), normal.normalized());
}

/// Looks textures up: the material's color, and the bumped outward normal.
RTB_HD inline void ApplyTextures(const ShadingView& shading,
                                 const GeometryView& geometry, const Hit& hit,
                                 const MaterialData& material, Interaction* at,
                                 V3f* outward) {
  if (material.checker.size > 0) {
    at->bsdf.color = ObjectCheckerColor(
        material.checker, geometry.objects[at->point.object], at->point);
  }
  if (material.texture < 0 && material.bump < 0) return;
  const SurfaceUv uv = UvAt(geometry, hit, at->point);
  const UvFootprint footprint =
      FootprintOf(uv, at->point.normal, -at->outgoing, at->cone.width);
  if (material.texture >= 0) {
    at->bsdf.color =
        TextureColor(shading.textures[material.texture], uv.uv, footprint);
  }
  if (material.bump >= 0) {
    *outward = BumpNormal(shading.bumps[material.bump], uv.uv, uv.dp_du,
                          uv.dp_dv, *outward, footprint);
  }
}

/// The interaction at a hit; `hit.kind` is not kNothing.
/// @param cone the beam around the ray, over which textures are averaged.
RTB_HD_CALLED inline Interaction MakeInteraction(const ShadingView& shading,
                                                 const GeometryView& geometry,
                                                 const Ray& ray, const Hit& hit,
                                                 const RayCone& cone = {}) {
  Interaction at;
  at.point = SurfaceAt(geometry, ray, hit);
  at.cone = cone.At((at.point.position - ray.origin).length());
  at.outgoing = -ray.direction;
  at.from_outside = ray.direction.dot(at.point.normal) < 0;
  at.geometric = at.from_outside ? at.point.normal : -at.point.normal;
  const ObjectData& object = geometry.objects[at.point.object];
  at.is_light = object.light >= 0;
  V3f outward = at.point.shading_normal;
  if (at.is_light) {
    at.bsdf.model = SurfaceModel::kEmissive;
    at.emitted = EmittedRadiance(shading.lights[object.light], ray.direction,
                                 at.point.normal);
  } else {
    const MaterialData& material = shading.material(object.material);
    at.bsdf = material.bsdf;
    at.reflectance = material.reflectance;
    ApplyTextures(shading, geometry, hit, material, &at, &outward);
    if (at.bsdf.model == SurfaceModel::kEmissive) at.emitted = at.bsdf.color;
  }
  at.normal = at.from_outside ? outward : -outward;
  // Interpolated or bumped so far that the viewer would be behind.
  if (!(at.normal.dot(at.outgoing) > 0)) at.normal = at.geometric;
  at.SetFrame();
  return at;
}

}  // namespace rtb
