#include "core/shading/light_choice.h"

#include <numeric>

#include "core/base/check.h"

namespace rtb {
namespace {

double Sum(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

/// How many of them shine.
double Count(std::span<const double> powers) {
  double count = 0;
  for (const double power : powers) count += power > 0 ? 1 : 0;
  return count;
}

}  // namespace

std::vector<double> ChoiceWeights(std::span<const double> powers,
                                  std::size_t declared) {
  RTB_CHECK_LT(declared, powers.size());
  const double total = Sum(powers);
  const double objects =
      Sum(powers.subspan(declared, powers.size() - declared - 1));
  const double shares = Count(powers.first(declared)) + (objects > 0 ? 1 : 0) +
                        Count(powers.last(1));
  std::vector<double> weights(powers.size(), 0);
  for (std::size_t i = 0; i < powers.size(); ++i) {
    if (!(powers[i] > 0)) continue;
    const bool of_objects = i >= declared && i + 1 < powers.size();
    const double share = of_objects ? powers[i] / objects : 1;
    weights[i] = powers[i] / total + share / shares;
  }
  return weights;
}

}  // namespace rtb
