/// @file
/// The choice among candidates that all fits share.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "encoders/blend.h"
#include "encoders/fit/moments.h"

namespace rtb {

/// Errors up to this are as good as `error`: noise of the samples moves an
/// error, a squared distance, by its root times their own.
inline double WithNoise(double error) {
  return error + kNoise * (std::sqrt(error) + kNoise);
}

/// What is known of a candidate before its colors are chosen.
struct Prospect {
  V3d correlation{0};
  /// No colors leave a lower error. Infinite for a candidate that is another
  /// one's complement: it leaves the same errors under a higher code point.
  double least = std::numeric_limits<double>::infinity();
};

/// All candidates of an atlas, in its order.
std::vector<Prospect> Survey(const Atlas& atlas,
                             const CenteredSamples& samples);

/// Of the candidates the one of least error, and of those that are as good the
/// first. `finish(i)` chooses the colors of candidate i and returns a fit with
/// its error, which is at least the prospect's.
template <class Finish>
auto ChooseBest(const std::vector<Prospect>& prospects, const Finish& finish) {
  using Finished = decltype(finish(std::size_t{0}));
  const auto likely = static_cast<std::size_t>(
      std::ranges::min_element(prospects, {}, &Prospect::least) -
      prospects.begin());
  const Finished first = finish(likely);
  double best = first.error;
  std::vector<Finished> finished;
  for (std::size_t i = 0; i < prospects.size(); ++i) {
    if (prospects[i].least > WithNoise(best)) continue;
    finished.push_back(i == likely ? first : finish(i));
    best = std::min(best, finished.back().error);
  }
  return *std::ranges::find_if(finished, [best](const Finished& fit) {
    return fit.error <= WithNoise(best);
  });
}

}  // namespace rtb
