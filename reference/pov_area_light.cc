#include "reference/pov_area_light.h"

#include <numbers>

#include "reference/pov_text.h"

namespace rtb {
namespace {

/// An emitter is a spotlight whose only falloff is the cosine. Its place on
/// the unit square (i / n and golden ratio steps) and on the sphere is a
/// Fibonacci lattice: Keinert et al., "Spherical Fibonacci Mapping", SIGGRAPH
/// Asia 2015, equation 1. Between passes the lattice moves by an R2 sequence:
/// M. Roberts, "The Unreasonable Effectiveness of Quasirandom Sequences",
/// 2018; the first pass has the lattice itself.
constexpr char kMacrosHead[] = R"(#ifndef (Emitters)
  #declare Emitters = 34;
#end
#declare PassNumber = PassRow * PassSide + PassColumn;
#declare ShiftU = mod(0.5 + PassNumber * 0.7548776662466927, 1);
#declare ShiftV = mod(0.5 + PassNumber * 0.5698402909980532, 1);
#declare Golden = 0.6180339887498949;
#macro Emitter(At, Normal, Power)
  light_source {
    At Power )";
/// They go on after the falloff.
constexpr char kMacrosTail[] = R"(
    spotlight point_at At + Normal radius 90 falloff 90 tightness 1
  }
#end
#macro QuadEmitters(Corner, EdgeA, EdgeB, Normal, Power)
  #local I = 0;
  #while (I < Emitters)
    #local U = (I + ShiftU) / Emitters;
    #local V = mod(I * Golden + ShiftV, 1);
    Emitter(Corner + EdgeA * U + EdgeB * V, Normal, Power / Emitters)
    #local I = I + 1;
  #end
#end
#macro SphereEmitters(Center, Radius, Power)
  #local Count = 2 * Emitters;
  #local I = 0;
  #while (I < Count)
    #local Z = 1 - 2 * (I + ShiftU) / Count;
    #local Angle = 2 * pi * (I * Golden + ShiftV);
    #local R = sqrt(1 - Z * Z);
    #local Normal = <R * cos(Angle), R * sin(Angle), Z>;
    Emitter(Center + Normal * Radius, Normal, Power / Count)
    #local I = I + 1;
  #end
#end
)";

std::string Glow(const Rgb& radiance) {
  return "pigment { " + PovColor(radiance) + " } finish { emission rgb 1 }";
}

/// The power of a whole light whose emitters share it.
std::string Power(const Rgb& radiance, double area, double scale) {
  return PovIntensity(radiance * static_cast<float>(area), scale);
}

/// The panel as it is seen: its front glows, its back is black. POV-Ray's
/// outside of a triangle is where it runs clockwise.
std::string QuadSurface(const QuadLight& light, const V3d& offset,
                        double scale) {
  const auto at = [&](double u, double v) {
    return PovVector(
        (light.corner + offset + light.edges[0] * u + light.edges[1] * v) *
        scale);
  };
  const std::string far = at(1, 1);
  return "mesh { triangle { " + at(0, 0) + ", " + far + ", " + at(1, 0) +
         " } triangle { " + at(0, 0) + ", " + at(0, 1) + ", " + far +
         " } texture { " + Glow(light.radiance) +
         " } interior_texture { pigment { rgb 0 } } }\n";
}

}  // namespace

std::string PovEmitterMacros() { return kMacrosHead + PovFade() + kMacrosTail; }

std::string PovQuadLight(const QuadLight& light, const V3d& offset,
                         double scale) {
  const V3d area = light.edges[0].cross(light.edges[1]);
  return QuadSurface(light, offset, scale) + "QuadEmitters(" +
         PovVector((light.corner + offset) * scale) + ", " +
         PovVector(light.edges[0] * scale) + ", " +
         PovVector(light.edges[1] * scale) + ", " +
         PovVector(area.normalized()) + ", " +
         Power(light.radiance, area.length(), scale) + ")\n";
}

std::string PovSphereLight(const SphereLight& light, const V3d& offset,
                           double scale) {
  const std::string center = PovVector((light.center + offset) * scale);
  const std::string radius = PovNumber(light.radius * scale);
  const double area = 4 * std::numbers::pi * light.radius * light.radius;
  return "sphere { " + center + ", " + radius + " texture { " +
         Glow(light.radiance) + " } }\nSphereEmitters(" + center + ", " +
         radius + ", " + Power(light.radiance, area, scale) + ")\n";
}

}  // namespace rtb
