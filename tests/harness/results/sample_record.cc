#include "tests/harness/results/sample_record.h"

namespace rtb {

namespace {

/// Everything that a run may carry; the first run of the record has none.
void AddMeasures(RunResult& run) {
  run.rays = RayCounts{12000, 300, 200, 100, 9000};
  run.bytes_per_frame = 123456;
  run.pictures = {"quality-ab12.0.cells.json.gz", "", "reference-cd34.jpg"};
  run.bound = BoundResult{"blocks+quadrants", 0.001, std::nullopt};
  run.decomposition = Decomposition{{1, 2, 4, 0.5, -0.25, 0.125, 7.375, 0.5},
                                    {0.1, 0.2, 0.3, 0.4, std::nullopt},
                                    InnerTerms{2, 1.5, 0.5}};
  run.temporal =
      TemporalResult{24, 12, 0.01, 0.02, std::nullopt, 0.3, 0.4, 0.5, 6000.5};
  run.live = LiveResult{60.5, {16, 17, 20}, 4096, 100.5, "direct"};
}

}  // namespace

RunRecord SampleRecord() {
  RunRecord record;
  record.manifest.build = {"0.1.0",   "0123456789abcdef", true,
                           "Release", "GNU 12.2.0",       "-O3"};
  record.manifest.settings.backend = "embree";
  record.manifest.settings.integrator = "whitted";
  record.manifest.settings.max_depth = 8;
  record.manifest.settings.seed = 18446744073709551615u;
  record.manifest.settings.reference = "povray";
  record.manifest.inputs = {{"scene", "cornell.yaml", std::string(64, 'a')},
                            {"reference", "cornell.exr", std::string(64, '0')}};
  record.runs = {
      {"cornell",
       "quadrant:blend=linear",
       {120, 40},
       4,
       {960, 640},
       {1920, 1280},
       {{"render", {2, 4, 6}, {3, 7, 11}}, {"encode", {1}, {}}},
       {{"flip", 0.1}, {"mse", 0.001637}, {"psnr", 27.86}, {"ssim", 0.5}}},
      {"cornell",
       "adaptive",
       {120, 40},
       2.5,
       {960, 640},
       {960, 640},
       {},
       {{"flip", 0.0}, {"psnr", std::nullopt}, {"ms_ssim", std::nullopt}},
       "1.12.4"}};
  AddMeasures(record.runs[1]);
  record.conditions.utc = "2026-01-31T12:34:56Z";
  record.conditions.command = {"rtbench", "--scene=cornell"};
  record.conditions.host = {"A CPU", 2, "An OS", "Linux 6.1", "host", 0.25};
  return record;
}

RunRecord SampleFailure() {
  RunRecord record = SampleRecord();
  record.runs.clear();
  record.unit = Unit{"quality",
                     "thesis",
                     "ab12",
                     {"cornell",
                      0.5,
                      {120, 40},
                      2,
                      "embree",
                      "path",
                      "256",
                      "self",
                      18446744073709551615u,
                      {"half", "external:jp2a --colors"}}};
  record.failure = RunFailure{"skipped", "external:jp2a --colors", "jp2a",
                              "the program is missing", "install jp2a"};
  return record;
}

}  // namespace rtb
