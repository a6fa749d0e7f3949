#include "harness/results/measures_json.h"
#include "harness/results/run_record_json.h"
#include "harness/results/unit_json.h"

namespace rtb {
namespace {

// These throw nlohmann's exceptions; ParseRecord catches them.

PixelSize ToSize(const Json& json) {
  return {json.at(0).get<int>(), json.at(1).get<int>()};
}

BuildInfo ToBuild(const Json& json) {
  return {json.at("version"),    json.at("commit"),   json.at("dirty"),
          json.at("build_type"), json.at("compiler"), json.at("flags")};
}

RunSettings ToSettings(const Json& json) {
  RunSettings s;
  json.at("backend").get_to(s.backend);
  json.at("device").get_to(s.device);
  json.at("integrator").get_to(s.integrator);
  json.at("spp").get_to(s.spp);
  json.at("max_depth").get_to(s.max_depth);
  json.at("seed").get_to(s.seed);
  json.at("time").get_to(s.time);
  json.at("exposure").get_to(s.exposure);
  s.cell = ToSize(json.at("cell"));
  json.at("reference").get_to(s.reference);
  json.at("color").get_to(s.color);
  json.at("decode").get_to(s.decode);
  json.at("blend").get_to(s.blend);
  json.at("ppd").get_to(s.ppd);
  return s;
}

Manifest ToManifest(const Json& json) {
  Manifest manifest;
  manifest.build = ToBuild(json.at("program"));
  manifest.settings = ToSettings(json.at("settings"));
  for (const Json& input : json.at("inputs")) {
    manifest.inputs.push_back(
        {input.at("role"), input.at("name"), input.at("sha256")});
  }
  return manifest;
}

StageTimes ToTimes(const std::string& stage, const Json& json) {
  StageTimes times{stage, json.at("samples"), {}};
  if (json.contains("cpu_samples")) {
    json.at("cpu_samples").get_to(times.cpu_samples);
  }
  return times;
}

/// Reads `key`, where it is there and not null, by `read`.
template <class T, class Read>
void ReadOptional(const Json& json, const char* key, Read read,
                  std::optional<T>& value) {
  const auto found = json.find(key);
  if (found != json.end() && !found->is_null()) value = read(*found);
}

void ReadMeasures(const Json& json, RunResult& run) {
  const auto number = [](const Json& n) { return n.get<std::uint64_t>(); };
  ReadOptional(json, "rays", ToRayCounts, run.rays);
  ReadOptional(json, "bytes_per_frame", number, run.bytes_per_frame);
  if (json.contains("pictures")) run.pictures = ToPictures(json["pictures"]);
  ReadOptional(json, "bound", ToBound, run.bound);
  ReadOptional(json, "decomposition", ToDecomposition, run.decomposition);
  ReadOptional(json, "temporal", ToTemporal, run.temporal);
  ReadOptional(json.at("ms"), "live", ToLive, run.live);
}

RunResult ToRun(const Json& json) {
  RunResult run;
  json.at("scene").get_to(run.scene);
  json.at("encoder").get_to(run.encoder);
  run.encoder_version = json.value("encoder_version", "");
  json.at("grid").at(0).get_to(run.grid.columns);
  json.at("grid").at(1).get_to(run.grid.rows);
  json.at("rays_per_cell").get_to(run.rays_per_cell);
  run.raster = ToSize(json.at("raster"));
  run.reference_raster = ToSize(json.at("reference_raster"));
  for (const auto& [stage, times] : json.at("ms").items()) {
    if (stage != "live") run.times.push_back(ToTimes(stage, times));
  }
  for (const auto& [name, value] : json.at("metrics").items()) {
    run.metrics.push_back({name, value.is_null() ? std::optional<double>()
                                                 : value.get<double>()});
  }
  ReadMeasures(json, run);
  return run;
}

HostInfo ToHost(const Json& json) {
  return {json.at("cpu_model"), json.at("cores"), json.at("os"),
          json.at("kernel"),    json.at("name"),  json.at("load_1min")};
}

RunConditions ToConditions(const Json& json) {
  return {json.at("utc"), json.at("command"), json.at("threads"),
          ToHost(json.at("host"))};
}

Result<RunRecord> ToRecord(const Json& json, const std::string& place) {
  const int schema = json.at("schema").get<int>();
  if (schema != kRecordSchema) {
    return Fail(BadInput(place,
                         "is a record of schema version " +
                             std::to_string(schema) + ", expected " +
                             std::to_string(kRecordSchema),
                         "make it anew with this version of the program"));
  }
  RunRecord record;
  ReadOptional(json, "unit", ToUnit, record.unit);
  ReadOptional(json, "failure", ToFailure, record.failure);
  record.manifest = ToManifest(json.at("manifest"));
  for (const Json& run : json.at("runs")) record.runs.push_back(ToRun(run));
  record.conditions = ToConditions(json.at("volatile"));
  for (const RunResult& run : record.runs) {
    for (const StageTimes& times : run.times) {
      if (times.samples.empty()) {
        return Fail(BadInput(place, "has no samples of stage '" + times.stage +
                                        "' in a run of " + run.encoder));
      }
    }
  }
  return record;
}

}  // namespace

Result<RunRecord> ParseRecord(std::string_view text, const std::string& place) {
  try {
    return ToRecord(Json::parse(text), place);
  } catch (const Json::exception& error) {
    return Fail(BadInput(place, std::string("is no record: ") + error.what(),
                         "records are described by record.schema.json"));
  }
}

}  // namespace rtb
