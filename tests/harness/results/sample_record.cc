#include "tests/harness/results/sample_record.h"

namespace rtb {

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
  record.conditions.utc = "2026-01-31T12:34:56Z";
  record.conditions.command = {"rtbench", "--scene=cornell"};
  record.conditions.host = {"A CPU", 2, "An OS", "Linux 6.1", "host", 0.25};
  return record;
}

}  // namespace rtb
