/// @file
/// What the tests of the BSDFs share: materials, views, uniforms, integrals.
#pragma once

#include <cmath>
#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

#include "core/math/gauss_legendre.h"
#include "core/math/random.h"
#include "core/shading/bsdf.h"
#include "tests/core/shading/direction_charts.h"

namespace rtb {

inline GgxEnergyView TestEnergy() {
  static const GgxEnergy energy = MakeGgxEnergy();
  return ViewOf(energy);
}

inline BsdfData TestMetal(const Rgb& f0, float roughness) {
  return MakeBsdf(SurfaceModel::kMetal, f0, 1, roughness, TestEnergy());
}

inline BsdfData TestPlastic(const Rgb& albedo, float ior, float roughness) {
  return MakeBsdf(SurfaceModel::kPlastic, albedo, ior, roughness, TestEnergy());
}

/// A unit direction of that cosine and azimuth.
inline V3f DirectionAt(float cosine, float phi = 0.7f) {
  const float sine = std::sqrt(1 - cosine * cosine);
  return V3f(sine * std::cos(phi), sine * std::sin(phi), cosine).normalized();
}

/// Three pseudo-random uniforms.
inline V3f RandomUniforms(std::uint32_t index, std::uint64_t seed) {
  return V3f(UnitFloat(RandomBits(index, 0, 0, seed)),
             UnitFloat(RandomBits(index, 0, 1, seed)),
             UnitFloat(RandomBits(index, 0, 2, seed)));
}

/// The integral over the hemisphere above the surface of f(wi), which may
/// have a GGX lobe of the BSDF's width around the mirror direction: by the
/// half vector's chart, Gauss-Legendre times the trapezoid rule. With 48
/// points it is good to 2e-5 for any roughness and cosines from 0.02.
template <class F>
V3d HemisphereIntegral(const BsdfData& bsdf, const V3f& wo, const F& f) {
  constexpr int kPoints = 48;
  const HalfVectorChart chart(wo, bsdf.alpha > 0 ? bsdf.alpha : 1);
  V3d sum(0);
  for (const QuadraturePoint& q : GaussLegendre(kPoints)) {
    for (int i = 0; i < 2 * kPoints; ++i) {
      const ChartPoint at = chart.At(V2d(q.x, (i + 0.5) / (2 * kPoints)));
      sum += V3d(f(at.direction)) * (q.weight * at.stretch / (2 * kPoints));
    }
  }
  return sum;
}

/// The integral of f cos: the directional albedo of what is not delta.
inline V3d SpreadAlbedo(const BsdfData& bsdf, const V3f& wo) {
  return HemisphereIntegral(bsdf, wo, [&](const V3f& wi) {
    return EvalBsdf(bsdf, TestEnergy(), wo, wi) * wi.z;
  });
}

/// A BSDF with a name for messages.
struct BsdfCase {
  std::string name;
  BsdfData bsdf;
};

inline void PrintTo(const BsdfCase& c, std::ostream* out) { *out << c.name; }

/// Every kind of BSDF with a part that is spread over directions.
inline std::vector<BsdfCase> SpreadCases() {
  const Rgb color(0.9f, 0.5f, 0.1f);
  std::vector<BsdfCase> cases = {
      {"Lambertian",
       MakeBsdf(SurfaceModel::kLambertian, color, 1, 0, TestEnergy())},
      {"SmoothPlastic", TestPlastic(color, 1.5f, 0)},
      {"BlackPlastic", TestPlastic(Rgb(0), 1.5f, 0.5f)}};
  for (const int percent : {5, 10, 20, 40, 70, 100}) {
    const float roughness = static_cast<float>(percent) / 100;
    const std::string digits = std::to_string(percent);
    cases.push_back({"Metal" + digits, TestMetal(color, roughness)});
    cases.push_back({"Plastic" + digits, TestPlastic(color, 1.5f, roughness)});
  }
  return cases;
}

}  // namespace rtb
