/// @file
/// Metric: one figure that compares a test image with a reference.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "core/base/result.h"
#include "core/image/image.h"

namespace rtb {

/// Two rasters of one size, as sRGB-encoded values in [0, 1]: what a display
/// would be given. The reference is rounded to 8 bits, a decoded grid is not.
struct MetricInput {
  const Image& reference;
  const Image& test;
};

/// One metric of metrics.inc.
struct Metric {
  const char* name;         ///< Its name in records: `flip`, `psnr`, ...
  const char* description;  ///< Definition in short, units, direction.
  bool lower_is_better;
  /// The figure; none where it is undefined (PSNR of identical images).
  std::optional<double> (*compute)(const MetricInput&);
};

/// All metrics, in the order of metrics.inc.
std::span<const Metric> Metrics();

/// The metric of that name, or nullptr.
const Metric* FindMetric(const std::string& name);

}  // namespace rtb
