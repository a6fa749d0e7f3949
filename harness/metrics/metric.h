/// @file
/// Metric: one figure that compares a test image with a reference. A metric
/// is one .cc file beside this one that defines `Metric <Name>Metric()`, and
/// its line in metrics.inc.
#pragma once

#include <any>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "core/image/image.h"

namespace rtb {

/// Two rasters of one size, as sRGB-encoded values in [0, 1]: what a display
/// would be given. The reference is rounded to 8 bits, a decoded grid is not.
/// What several metrics need of the pair is computed once and kept here. To be
/// used by one thread at a time; the images must outlive it.
class MetricInput {
 public:
  /// Both images must have the same size and at least one pixel.
  /// @param threads for the metrics' own loops, 0 = all cores; no figure
  ///   depends on it.
  MetricInput(const Image& reference, const Image& test, int threads = 0);

  const Image& reference() const { return reference_; }
  const Image& test() const { return test_; }
  int width() const { return reference_.width(); }
  int height() const { return reference_.height(); }
  int threads() const { return threads_; }

  /// The T that `make()` returned the first time it was asked for under this
  /// key. A key belongs to one type.
  template <class T, class Make>
  const T& Once(const std::string& key, const Make& make) const {
    auto found = derived_.find(key);
    if (found == derived_.end()) {
      std::any made = std::make_any<T>(make());  // May itself call Once.
      found = derived_.emplace(key, std::move(made)).first;
    }
    const T* value = std::any_cast<T>(&found->second);
    RTB_CHECK(value != nullptr);
    return *value;
  }

 private:
  const Image& reference_;
  const Image& test_;
  int threads_;
  mutable std::map<std::string, std::any> derived_;
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

/// One figure of a comparison.
struct MetricValue {
  std::string name;
  std::optional<double> value;

  bool operator==(const MetricValue&) const = default;
};

/// Every metric of the pair, in the order of metrics.inc.
std::vector<MetricValue> ComputeMetrics(const MetricInput& input);

/// The same from images of a user: different or zero sizes are an Error.
/// @param reference,test sRGB-encoded values in [0, 1].
Result<std::vector<MetricValue>> Score(const Image& reference,
                                       const Image& test, int threads = 0);

}  // namespace rtb
