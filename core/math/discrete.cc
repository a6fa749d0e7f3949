#include "core/math/discrete.h"

#include <cstddef>
#include <limits>

#include "core/base/check.h"

namespace rtb {

double FillCdf(std::span<const double> weights, std::span<float> cdf) {
  RTB_CHECK_GT(weights.size(), 0u);
  RTB_CHECK_EQ(cdf.size(), weights.size() + 1);
  double total = 0;
  for (const double weight : weights) {
    RTB_CHECK_GE(weight, 0);
    total += weight;
  }
  RTB_CHECK_LE(total, std::numeric_limits<double>::max());
  const bool any = total > 0;
  const double whole = any ? total : static_cast<double>(weights.size());
  double sum = 0;
  cdf[0] = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    sum += any ? weights[i] : 1;
    cdf[i + 1] = static_cast<float>(sum / whole);
  }
  return total;
}

std::vector<float> MakeCdf(std::span<const double> weights) {
  std::vector<float> cdf(weights.size() + 1);
  FillCdf(weights, cdf);
  return cdf;
}

}  // namespace rtb
