/// @file
/// The light that a rough lobe receives of lights with extent, by points on
/// the light and by rays of the lobe together: the former find what a wide
/// lobe gets of a small light, the latter what a narrow one gets of a large
/// one. Host and device.
///
/// Veach and Guibas, "Optimally Combining Sampling Techniques for Monte Carlo
/// Rendering", SIGGRAPH 1995, section 3: each sample of either is weighed
/// against the other, by densities times numbers of samples.
#pragma once

#include <algorithm>

#include "core/base/host_device.h"
#include "core/render/power_heuristic.h"
#include "core/shading/interaction.h"
#include "core/shading/light.h"

namespace rtb {

/// f |cos| towards a point of a light, of whose part in the lobe the lobe's
/// own rays bring the rest.
/// @param sample of SampleLightByArea.
/// @param rays of the lobe for each of the light's points.
RTB_HD inline Rgb LobeResponse(const Interaction& at,
                               const GgxEnergyView& energy,
                               const LightSample& sample, float rays) {
  if (!(sample.direction.dot(at.geometric) > 0)) return Rgb(0);
  const V3f wo = at.ToLocal(at.outgoing), wi = at.ToLocal(sample.direction);
  const float pdf = PdfGlossy(at.bsdf, energy, wo, wi);
  return (EvalDiffuse(at.bsdf, wo, wi) +
          EvalGlossy(at.bsdf, energy, wo, wi) *
              PowerHeuristic(sample.pdf, rays * pdf)) *
         std::max(0.0f, wi.z);
}

/// The weight of a light that a ray of the lobe has hit.
/// @param pdf of the ray, times the number of such rays.
/// @param distance along it to the light.
/// @param points that were taken on the light instead.
RTB_HD inline float LobeRayWeight(const LightData& light, const Ray& ray,
                                  float pdf, float distance, int points) {
  const float of_light =
      LightPdfByArea(light, ray.origin, ray.direction, distance);
  return PowerHeuristic(pdf, of_light * static_cast<float>(points));
}

}  // namespace rtb
