#include "harness/results/run_record_json.h"

#include "harness/results/measures_json.h"
#include "harness/results/statistics.h"
#include "harness/results/unit_json.h"

namespace rtb {
namespace {

Json ToJson(PixelSize size) { return {size.width, size.height}; }

Json ToJson(const BuildInfo& build) {
  return {{"version", build.version},   {"commit", build.commit},
          {"dirty", build.dirty},       {"build_type", build.build_type},
          {"compiler", build.compiler}, {"flags", build.flags}};
}

Json ToJson(const RunSettings& s) {
  return {{"backend", s.backend},
          {"device", s.device},
          {"integrator", s.integrator},
          {"spp", s.spp},
          {"max_depth", s.max_depth},
          {"seed", s.seed},
          {"time", s.time},
          {"exposure", s.exposure},
          {"cell", ToJson(s.cell)},
          {"reference", s.reference},
          {"color", s.color},
          {"decode", s.decode},
          {"blend", s.blend},
          {"ppd", s.ppd}};
}

Json ToJson(const InputFile& input) {
  return {{"role", input.role}, {"name", input.name}, {"sha256", input.sha256}};
}

Json ToJson(const Manifest& manifest) {
  Json inputs = Json::array();
  for (const InputFile& input : manifest.inputs) {
    inputs.push_back(ToJson(input));
  }
  return {{"program", ToJson(manifest.build)},
          {"settings", ToJson(manifest.settings)},
          {"inputs", inputs}};
}

Json TimesOf(const RunResult& run) {
  Json ms = Json::object();
  for (const StageTimes& times : run.times) {
    ms[times.stage] = TimesToJson(times);
  }
  if (run.live) ms["live"] = rtb::ToJson(*run.live);
  return ms;
}

/// Adds the measures that a run carries.
void AddMeasures(const RunResult& run, Json& object) {
  if (run.rays) object["rays"] = rtb::ToJson(*run.rays);
  if (run.bytes_per_frame) object["bytes_per_frame"] = *run.bytes_per_frame;
  if (run.pictures != RunPictures{}) {
    object["pictures"] = rtb::ToJson(run.pictures);
  }
  if (run.bound) {
    object["bound"] = rtb::ToJson(*run.bound);
  } else if (run.decomposition) {
    object["bound"] = nullptr;
  }
  if (run.decomposition) {
    object["decomposition"] = rtb::ToJson(*run.decomposition);
  }
  if (run.temporal) object["temporal"] = rtb::ToJson(*run.temporal);
}

Json ToJson(const RunResult& run) {
  Json object = {{"scene", run.scene},
                 {"encoder", run.encoder},
                 {"grid", Json::array({run.grid.columns, run.grid.rows})},
                 {"rays_per_cell", run.rays_per_cell},
                 {"raster", ToJson(run.raster)},
                 {"reference_raster", ToJson(run.reference_raster)},
                 {"ms", TimesOf(run)},
                 {"metrics", MetricsToJson(run.metrics)}};
  if (!run.encoder_version.empty()) {
    object["encoder_version"] = run.encoder_version;
  }
  AddMeasures(run, object);
  return object;
}

Json ToJson(const HostInfo& host) {
  return {{"name", host.hostname}, {"cpu_model", host.cpu_model},
          {"cores", host.cores},   {"os", host.os},
          {"kernel", host.kernel}, {"load_1min", host.load_1min}};
}

Json ToJson(const RunConditions& conditions) {
  return {{"utc", conditions.utc},
          {"command", conditions.command},
          {"threads", conditions.threads},
          {"host", ToJson(conditions.host)}};
}

}  // namespace

Json MetricsToJson(std::span<const MetricValue> metrics) {
  Json object = Json::object();
  for (const MetricValue& metric : metrics) {
    object[metric.name] = metric.value ? Json(*metric.value) : Json(nullptr);
  }
  return object;
}

Json TimesToJson(const StageTimes& times) {
  const Summary summary = Summarize(times.samples);
  Json object = {{"median", summary.median},
                 {"lo", summary.interval.lo},
                 {"hi", summary.interval.hi},
                 {"p95", summary.p95},
                 {"cv", summary.cv}};
  if (!times.cpu_samples.empty()) {
    object["cpu_median"] = Median(times.cpu_samples);
    object["cpu_samples"] = times.cpu_samples;
  }
  object["samples"] = times.samples;
  return object;
}

Json RecordToJson(const RunRecord& record) {
  Json runs = Json::array();
  for (const RunResult& run : record.runs) runs.push_back(ToJson(run));
  Json object = {{"schema", kRecordSchema}};
  if (record.unit) object["unit"] = ToJson(*record.unit);
  if (record.failure) object["failure"] = ToJson(*record.failure);
  object["manifest"] = ToJson(record.manifest);
  object["runs"] = runs;
  object["volatile"] = ToJson(record.conditions);
  return object;
}

std::string FormatRecord(const RunRecord& record) {
  // Bytes that are no UTF-8 (in a file's name, say) are replaced: a record
  // never fails to be written.
  return RecordToJson(record).dump(2, ' ', /*ensure_ascii=*/false,
                                   Json::error_handler_t::replace) +
         "\n";
}

}  // namespace rtb
