/// @file
/// The JSON form of RunRecord: results/record.schema.json.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "harness/results/json.h"
#include "harness/results/run_record.h"

namespace rtb {

/// `{"flip": 0.1, "psnr": null, ...}`; undefined values are null.
Json MetricsToJson(std::span<const MetricValue> metrics);

/// `{"median", "lo", "hi", "p95", "cv", "samples"}` of a stage, beside
/// `cpu_median` where CPU times were taken.
Json TimesToJson(const StageTimes& times);

/// The whole record.
Json RecordToJson(const RunRecord& record);

/// The text of a record: indented by two, ending in a newline.
std::string FormatRecord(const RunRecord& record);

/// Reads what FormatRecord wrote. Another schema version, missing keys and
/// wrong types are Errors at `place`; the derived figures of times are
/// computed anew from their samples.
Result<RunRecord> ParseRecord(std::string_view text, const std::string& place);

}  // namespace rtb
