/// @file
/// Lights.
#include <array>

#include "core/scene/read_shapes.h"
#include "core/scene/scene_reader.h"

namespace rtb {
namespace {

using Kind = decltype(Light::kind);

constexpr int kMaxSamples = 1'000'000;

Kind ReadPoint(MapReader& reader) {
  static const std::array<std::string, 2> kFalloffs = {"inverse_square",
                                                       "none"};
  PointLight light;
  light.position = reader.Vector("position");
  light.intensity = reader.Color("intensity", kNonNegative);
  light.inverse_square = reader.Choice("falloff", kFalloffs, 0) == 0;
  return light;
}

Kind ReadDirectional(MapReader& reader) {
  const V3d direction = reader.Direction("direction");
  return DirectionalLight{direction, reader.Color("irradiance", kNonNegative)};
}

Kind ReadSpot(MapReader& reader) {
  SpotLight light;
  light.position = reader.Vector("position");
  light.direction = reader.Direction("direction");
  light.intensity = reader.Color("intensity", kNonNegative);
  light.cone = reader.Number("cone", kConeAngle);
  light.penumbra = reader.Number("penumbra", kRightAngle, 0);
  if (reader.complete() && light.cone + light.penumbra > kRightAngle.high) {
    reader.context().Fail(
        reader.MarkOf(reader.Has("penumbra") ? "penumbra" : "cone"),
        "`cone` and `penumbra` add up to more than 90 degrees");
  }
  return light;
}

Kind ReadQuad(MapReader& reader) {
  QuadLight light;
  light.corner = reader.Vector("corner");
  light.edges = ReadEdges(reader);
  light.radiance = reader.Color("radiance", kNonNegative);
  light.samples = reader.Integer("samples", 1, kMaxSamples, light.samples);
  return light;
}

Kind ReadSphere(MapReader& reader) {
  SphereLight light;
  light.center = reader.Vector("center");
  light.radius = reader.Number("radius", kPositive);
  light.radiance = reader.Color("radiance", kNonNegative);
  light.samples = reader.Integer("samples", 1, kMaxSamples, light.samples);
  return light;
}

/// The readers, in the order of kNames.
constexpr std::array<Kind (*)(MapReader&), 5> kReaders = {
    ReadPoint, ReadDirectional, ReadSpot, ReadQuad, ReadSphere};
const std::array<std::string, 5> kNames = {"point", "directional", "spot",
                                           "quad", "sphere"};

}  // namespace

void SceneReader::ReadLights(MapReader& root) {
  for (const YamlNode& node : Section(root, "lights")) {
    ReadLight(node);
    if (!context_.ok()) return;
  }
}

void SceneReader::ReadLight(YamlNode node) {
  MapReader reader(node, "a light", context_);
  Light light;
  light.mark = reader.mark();
  light.id = reader.Name("id", "");
  const std::size_t type = reader.Type(kNames);
  if (!context_.ok()) return;
  reader.set_owner("a light of type " + kNames[type]);
  light.path = Reference(reader, "path", path_ids_);
  light.kind = kReaders[type](reader);
  AddId(reader, light.id, static_cast<Index>(scene_.lights.size()),
        &light_ids_);
  reader.Finish();
  if (context_.ok()) scene_.lights.push_back(std::move(light));
}

}  // namespace rtb
