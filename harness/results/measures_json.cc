#include "harness/results/measures_json.h"

namespace rtb {
namespace {

Json ToJson(const MseTerms& mse) {
  return {{"render", mse.render},
          {"sampling", mse.sampling},
          {"encoding", mse.encoding},
          {"render_sampling", mse.render_sampling},
          {"render_encoding", mse.render_encoding},
          {"sampling_encoding", mse.sampling_encoding},
          {"total", mse.total},
          {"font", OptionalToJson(mse.font)}};
}

MseTerms ToMseTerms(const Json& json) {
  return {json.at("render"),          json.at("sampling"),
          json.at("encoding"),        json.at("render_sampling"),
          json.at("render_encoding"), json.at("sampling_encoding"),
          json.at("total"),           ToOptional(json.at("font"))};
}

Json ToJson(const FlipDistances& flip) {
  return {{"reference_converged", flip.reference_converged},
          {"converged_fragments", flip.converged_fragments},
          {"fragments_grid", flip.fragments_grid},
          {"reference_grid", flip.reference_grid},
          {"oracle", OptionalToJson(flip.oracle)}};
}

FlipDistances ToFlipDistances(const Json& json) {
  return {json.at("reference_converged"), json.at("converged_fragments"),
          json.at("fragments_grid"), json.at("reference_grid"),
          ToOptional(json.at("oracle"))};
}

Json ToJson(const std::optional<InnerTerms>& inner) {
  if (!inner) return nullptr;
  return {{"capacity", inner->capacity},
          {"masks", inner->masks},
          {"colors", inner->colors}};
}

std::optional<InnerTerms> ToInnerTerms(const Json& json) {
  if (json.is_null()) return std::nullopt;
  return InnerTerms{json.at("capacity"), json.at("masks"), json.at("colors")};
}

}  // namespace

Json OptionalToJson(std::optional<double> value) {
  return value ? Json(*value) : Json(nullptr);
}

std::optional<double> ToOptional(const Json& json) {
  if (json.is_null()) return std::nullopt;
  return json.get<double>();
}

Json ToJson(const RayCounts& rays) {
  return {{"camera", rays.camera},
          {"reflection", rays.reflection},
          {"refraction", rays.refraction},
          {"scattered", rays.scattered},
          {"shadow", rays.shadow}};
}

RayCounts ToRayCounts(const Json& json) {
  return {json.at("camera"), json.at("reflection"), json.at("refraction"),
          json.at("scattered"), json.at("shadow")};
}

Json ToJson(const RunPictures& pictures) {
  Json object = Json::object();
  if (!pictures.cells.empty()) object["cells"] = pictures.cells;
  if (!pictures.flip.empty()) object["flip"] = pictures.flip;
  if (!pictures.reference.empty()) object["reference"] = pictures.reference;
  return object;
}

RunPictures ToPictures(const Json& json) {
  return {json.value("cells", ""), json.value("flip", ""),
          json.value("reference", "")};
}

Json ToJson(const BoundResult& bound) {
  return {{"glyphs", bound.glyphs},
          {"mse", bound.mse},
          {"gap", OptionalToJson(bound.gap)}};
}

BoundResult ToBound(const Json& json) {
  return {json.at("glyphs"), json.at("mse"), ToOptional(json.at("gap"))};
}

Json ToJson(const Decomposition& decomposition) {
  return {{"mse", ToJson(decomposition.mse)},
          {"flip", ToJson(decomposition.flip)},
          {"inner", ToJson(decomposition.inner)}};
}

Decomposition ToDecomposition(const Json& json) {
  return {ToMseTerms(json.at("mse")), ToFlipDistances(json.at("flip")),
          ToInnerTerms(json.at("inner"))};
}

Json ToJson(const TemporalResult& temporal) {
  return {{"frames", temporal.frames},
          {"fps", temporal.fps},
          {"tde", temporal.tde},
          {"t_flip", temporal.t_flip},
          {"warp_error", OptionalToJson(temporal.warp_error)},
          {"churn", temporal.churn},
          {"static_flicker", temporal.static_flicker},
          {"static_flicker_rms", temporal.static_flicker_rms},
          {"bytes_per_frame", temporal.bytes_per_frame}};
}

TemporalResult ToTemporal(const Json& json) {
  return {json.at("frames"),
          json.at("fps"),
          json.at("tde"),
          json.at("t_flip"),
          ToOptional(json.at("warp_error")),
          json.at("churn"),
          json.at("static_flicker"),
          json.at("static_flicker_rms"),
          json.at("bytes_per_frame")};
}

Json ToJson(const LiveResult& live) {
  return {{"fps", live.fps},
          {"frame_ms",
           {{"p50", live.frame_ms.p50},
            {"p95", live.frame_ms.p95},
            {"p99", live.frame_ms.p99}}},
          {"bytes_per_frame", live.bytes_per_frame},
          {"cells_per_frame", live.cells_per_frame},
          {"present", live.present}};
}

LiveResult ToLive(const Json& json) {
  const Json& ms = json.at("frame_ms");
  return {json.at("fps"),
          {ms.at("p50"), ms.at("p95"), ms.at("p99")},
          json.at("bytes_per_frame"),
          json.at("cells_per_frame"),
          json.at("present")};
}

}  // namespace rtb
