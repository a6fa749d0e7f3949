#include "encoders/fit/survey_plan.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>

#include "core/base/check.h"

namespace rtb {
namespace {

/// The weight of each band.
using BandWeights = std::vector<double>;

double At(const FitMask& mask, const SurveyBands& bands, int x, int y) {
  return mask.coverage[static_cast<std::size_t>(y * bands.width + x)];
}

/// The mask as row halves, if each is covered evenly.
std::optional<BandWeights> AsRows(const FitMask& mask,
                                  const SurveyBands& bands) {
  BandWeights weights(static_cast<std::size_t>(bands.count()));
  for (int y = 0; y < bands.height; ++y) {
    for (int x = 0; x < bands.width; ++x) {
      const bool right = x >= bands.middle();
      const double m = At(mask, bands, x, y);
      if (m != At(mask, bands, right ? bands.middle() : 0, y)) {
        return std::nullopt;
      }
      weights[static_cast<std::size_t>(2 * y + (right ? 1 : 0))] = m;
    }
  }
  return weights;
}

/// The mask as columns, if each is covered evenly.
std::optional<BandWeights> AsColumns(const FitMask& mask,
                                     const SurveyBands& bands) {
  BandWeights weights(static_cast<std::size_t>(bands.count()));
  for (int x = 0; x < bands.width; ++x) {
    for (int y = 0; y < bands.height; ++y) {
      const double m = At(mask, bands, x, y);
      if (m != At(mask, bands, x, 0)) return std::nullopt;
      weights[static_cast<std::size_t>(bands.column(x))] = m;
    }
  }
  return weights;
}

/// Places where two masks of whole bands differ.
long Distance(const BandWeights& a, const BandWeights& b) {
  long distance = 0;
  for (std::size_t i = 0; i < a.size(); ++i) distance += a[i] != b[i] ? 1 : 0;
  return distance;
}

/// Adds candidates to a plan one by one.
class PlanMaker {
 public:
  explicit PlanMaker(SurveyPlan& plan)
      : plan_(plan), nothing_(static_cast<std::size_t>(plan.bands.count())) {}

  void Add(const FitMask& mask, int index) {
    SurveyCandidate candidate = Describe(mask, index);
    std::optional<BandWeights> weights = AsRows(mask, plan_.bands);
    if (!weights) weights = AsColumns(mask, plan_.bands);
    candidate.first_term = plan_.terms.size();
    if (!weights) {
      AddTerms(candidate, SurveyWay::kPixels, mask.coverage);
      plan_.has_pixels = true;
    } else if (mask.binary()) {
      AddDifference(candidate, *weights);
    } else {
      AddTerms(candidate, SurveyWay::kBands, *weights);
    }
    candidate.end_term = plan_.terms.size();
    if (candidate.way != SurveyWay::kDifference)
      candidate.slack = Slack(mask, candidate);
    whole_.push_back(candidate.way == SurveyWay::kDifference ? *weights
                                                             : BandWeights());
    plan_.candidates.push_back(candidate);
  }

 private:
  static SurveyCandidate Describe(const FitMask& mask, int index) {
    SurveyCandidate candidate{};
    const double n = mask.size();
    candidate.index = index;
    candidate.binary = mask.binary();
    candidate.share = static_cast<float>(mask.sum / n);
    candidate.inverse_variance =
        mask.constant() ? 0 : static_cast<float>(1 / mask.variance);
    candidate.aa = static_cast<float>(mask.sum_squares);
    candidate.twice_ab = static_cast<float>(2 * (mask.sum - mask.sum_squares));
    candidate.bb = static_cast<float>(n - 2 * mask.sum + mask.sum_squares);
    candidate.covered =
        static_cast<float>(std::ranges::count(mask.coverage, 1.0));
    candidate.free = static_cast<float>(std::ranges::count(mask.coverage, 0.0));
    return candidate;
  }

  void AddTerms(SurveyCandidate& candidate, SurveyWay way,
                const std::vector<double>& weights) {
    candidate.way = way;
    for (std::size_t i = 0; i < weights.size(); ++i) {
      if (weights[i] == 0) continue;
      plan_.terms.push_back(
          {static_cast<int>(i), static_cast<float>(weights[i])});
    }
  }

  /// What the candidate has more or less than the most similar one before.
  void AddDifference(SurveyCandidate& candidate, const BandWeights& weights) {
    candidate.way = SurveyWay::kDifference;
    candidate.parent = -1;
    const BandWeights* nearest = &nothing_;
    for (std::size_t i = 0; i < whole_.size(); ++i) {
      if (whole_[i].empty()) continue;
      if (Distance(whole_[i], weights) >= Distance(*nearest, weights)) continue;
      nearest = &whole_[i];
      candidate.parent = static_cast<int>(i);
    }
    for (std::size_t i = 0; i < weights.size(); ++i) {
      const double difference = weights[i] - (*nearest)[i];
      if (difference == 0) continue;
      plan_.terms.push_back(
          {static_cast<int>(i), static_cast<float>(difference)});
    }
  }

  /// A sum p of K rounded products errs by at most (K + 3) u sum |x|, u the
  /// unit roundoff, sum |x| <= (n S)^1/2 and |p| <= (V S)^1/2; so p^2 / V errs
  /// by at most 2 (K + 3) u (n / V)^1/2 S.
  static float Slack(const FitMask& mask, const SurveyCandidate& candidate) {
    if (mask.constant()) return 0;
    constexpr double kRoundoff = 0x1p-24;
    const auto terms =
        static_cast<double>(candidate.end_term - candidate.first_term);
    return static_cast<float>(2.1 * (terms + 3) * kRoundoff *
                              std::sqrt(mask.size() / mask.variance));
  }

  SurveyPlan& plan_;
  BandWeights nothing_;
  std::vector<BandWeights> whole_;  ///< Of kDifference; else empty.
};

/// With one color s at the distance delta <= 1/2 from its code, any other pair
/// of codes leaves at least k (1 - delta)^2 + (n - p - k) delta^2, where k is
/// the lesser of `covered` and `free` and p the number of sub-pixels in
/// between; both colors in that code leave n delta^2. The latter is less while
/// p delta^2 + 2 k delta - k < 0.
double FlatLimit(const SurveyCandidate& candidate, double n) {
  if (candidate.binary) return 0.5;
  const double k = std::min(candidate.covered, candidate.free);
  const double p = n - candidate.covered - candidate.free;
  // A little less, so that rounding errors decide nothing.
  return 0.99 * (std::sqrt(k * k + p * k) - k) / p;
}

}  // namespace

SurveyPlan::SurveyPlan(const Atlas& atlas)
    : bands{atlas.width(), atlas.height()} {
  const int samples = atlas.width() * atlas.height();
  RTB_CHECK_LE(samples, kMaxSamples);
  PlanMaker maker(*this);
  const auto masks = atlas.candidates();
  for (std::size_t i = 0; i < masks.size(); ++i) {
    if (masks[i].complement < 0) maker.Add(masks[i], static_cast<int>(i));
  }
  for (const SurveyCandidate& candidate : candidates) {
    flat_limit = std::min(flat_limit, FlatLimit(candidate, samples));
  }
  if (masks[0].sum != 0) flat_limit = -1;  // No space.
}

}  // namespace rtb
