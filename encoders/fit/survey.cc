#include "encoders/fit/survey.h"

#include <hwy/cache_control.h>

#include <bit>

#include "core/base/check.h"

// This file is compiled once for each target.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "encoders/fit/survey.cc"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "encoders/fit/survey_lanes-inl.h"
#include "encoders/fit/survey_read-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rtb {
namespace HWY_NAMESPACE {

/// The errors of all candidates.
class CandidateSurvey {
 public:
  HWY_INLINE CandidateSurvey(const SurveyPlan& plan, SurveyBatch& batch)
      : plan_(plan), batch_(batch) {
    const auto samples =
        static_cast<float>(plan.bands.width * plan.bands.height);
    const auto rest = [&](std::size_t c) HWY_ATTR {
      return ToFloats(LoadInts(batch.rest, c));
    };
    rest_ = {rest(0), rest(1), rest(2)};
    const auto offset = [&](std::size_t c, F r) HWY_ATTR {
      const I mean = LoadInts(batch.mean, c);
      constexpr int kShift = std::countr_zero(unsigned{kStepsPerCode});
      const I code = hn::ShiftLeft<kShift>(hn::ShiftRight<kShift>(mean));
      return hn::Mul(
          hn::MulAdd(r, Same(1 / samples), ToFloats(hn::Sub(mean, code))),
          Same(1.0f / kStepsPerCode));
    };
    mean_ = {offset(0, rest_.r), offset(1, rest_.g), offset(2, rest_.b)};
    spread_ = LoadFloats(batch.spread, 0);
    root_ = hn::Sqrt(spread_);
  }

  HWY_INLINE void Run() {
    F least = Same(kFar);
    F second = Same(kFar);
    I chosen = Same(0);
    for (std::size_t i = 0; i < plan_.candidates.size(); ++i) {
      const F error = ErrorOf(i);
      Put(error, batch_.errors, i);
      const auto better = hn::Lt(error, least);
      second = hn::Min(second, hn::Max(error, least));
      chosen = hn::IfThenElse(hn::RebindMask(SurveyInts(), better),
                              Same(static_cast<int>(i)), chosen);
      least = hn::Min(least, error);
    }
    Put(least, batch_.least, 0);
    Put(second, batch_.second, 0);
    Put(chosen, batch_.chosen, 0);
  }

 private:
  static constexpr float kFar = 1e30f;

  HWY_INLINE F ErrorOf(std::size_t i) {
    const SurveyCandidate& candidate = plan_.candidates[i];
    const Channels<F> sum = SumOf(candidate, i);
    const F error =
        hn::Add(hn::Add(ChannelError(candidate, sum.r, rest_.r, mean_.r),
                        ChannelError(candidate, sum.g, rest_.g, mean_.g)),
                ChannelError(candidate, sum.b, rest_.b, mean_.b));
    return hn::NegMulAdd(
        Same(candidate.slack), spread_,
        hn::NegMulAdd(Same(candidate.root_slack), root_, error));
  }

  /// What one channel leaves: the squared distance of two codes from the best
  /// colors, weighted, less p^2 / V. Of codes that are not both the nearest
  /// one is a whole code further off, and counts at least where the coverage
  /// is 1, or 0.
  HWY_INLINE F ChannelError(const SurveyCandidate& candidate, F sum, F rest,
                            F mean) {
    const F share = Same(candidate.share);
    const F p =
        hn::Mul(hn::NegMulAdd(share, rest, sum), Same(1.0f / kStepsPerCode));
    const F difference = hn::Mul(p, Same(candidate.inverse_variance));
    const F bg = hn::NegMulAdd(difference, share, mean);
    const F off_fg = Offset(hn::Add(bg, difference));
    const F off_bg = Offset(bg);
    const F fg2 = hn::Mul(off_fg, off_fg);
    const F bg2 = hn::Mul(off_bg, off_bg);
    F rounding =
        hn::MulAdd(Same(candidate.aa), fg2, hn::Mul(Same(candidate.bb), bg2));
    if (!candidate.binary) {
      rounding = hn::MulAdd(Same(candidate.twice_ab), hn::Mul(off_fg, off_bg),
                            rounding);
      const F covered = Same(candidate.covered);
      const F free = Same(candidate.free);
      const F other_fg =
          hn::MulAdd(covered, Beyond(off_fg), hn::Mul(free, bg2));
      const F other_bg =
          hn::MulAdd(free, Beyond(off_bg), hn::Mul(covered, fg2));
      rounding = hn::Min(rounding, hn::Min(other_fg, other_bg));
    }
    return hn::NegMulAdd(p, difference, rounding);
  }

  /// To the nearest whole code.
  static HWY_INLINE F Offset(F value) {
    return hn::Sub(value, hn::Round(value));
  }
  /// Squared distance from the next but one.
  static HWY_INLINE F Beyond(F offset) {
    const F distance = hn::Sub(Same(1.0f), hn::Abs(offset));
    return hn::Mul(distance, distance);
  }

  HWY_INLINE Channels<F> SumOf(const SurveyCandidate& candidate,
                               std::size_t i) {
    if (candidate.way == SurveyWay::kDifference) {
      return SumDifference(candidate, i);
    }
    if (candidate.way == SurveyWay::kBands) return SumBands(candidate);
    return SumPixels(candidate);
  }

  HWY_INLINE Channels<F> SumDifference(const SurveyCandidate& candidate,
                                       std::size_t i) {
    Channels<I> sum = SameInAll(0);
    if (candidate.parent >= 0) {
      sum = LoadTriple(batch_.sums, static_cast<std::size_t>(candidate.parent));
    }
    for (std::size_t t = candidate.first_term; t < candidate.end_term; ++t) {
      const SurveyTerm& term = plan_.terms[t];
      const Channels<I> band =
          LoadTriple(batch_.bands, static_cast<std::size_t>(term.index));
      sum = term.weight > 0 ? sum + band : sum - band;
    }
    PutTriple(sum, batch_.sums, i);
    return {ToFloats(sum.r), ToFloats(sum.g), ToFloats(sum.b)};
  }

  HWY_INLINE Channels<F> SumBands(const SurveyCandidate& candidate) {
    Channels<F> sum = {Same(0.0f), Same(0.0f), Same(0.0f)};
    for (std::size_t t = candidate.first_term; t < candidate.end_term; ++t) {
      const SurveyTerm& term = plan_.terms[t];
      const Channels<I> band =
          LoadTriple(batch_.bands, static_cast<std::size_t>(term.index));
      const F weight = Same(term.weight);
      sum = {hn::MulAdd(weight, ToFloats(band.r), sum.r),
             hn::MulAdd(weight, ToFloats(band.g), sum.g),
             hn::MulAdd(weight, ToFloats(band.b), sum.b)};
    }
    return sum;
  }

  HWY_INLINE Channels<F> SumPixels(const SurveyCandidate& candidate) {
    Channels<F> sum = {Same(0.0f), Same(0.0f), Same(0.0f)};
    for (std::size_t t = candidate.first_term; t < candidate.end_term; ++t) {
      const SurveyTerm& term = plan_.terms[t];
      const std::size_t at = kChannels * static_cast<std::size_t>(term.index);
      const F weight = Same(term.weight);
      sum = {hn::MulAdd(weight, LoadFloats(batch_.pixels, at), sum.r),
             hn::MulAdd(weight, LoadFloats(batch_.pixels, at + 1), sum.g),
             hn::MulAdd(weight, LoadFloats(batch_.pixels, at + 2), sum.b)};
    }
    return sum;
  }

  const SurveyPlan& plan_;
  SurveyBatch& batch_;
  Channels<F> rest_;
  Channels<F> mean_;  ///< In codes, from a whole code on.
  F spread_;
  F root_;
};

/// Has memory that is read soon brought near.
HWY_INLINE void Expect(const float* values, std::size_t count) {
  constexpr std::size_t kLine = 64 / sizeof(float);
  for (std::size_t i = 0; i < count; i += kLine) hwy::Prefetch(values + i);
}

std::size_t SurveyAll(const SurveyPlan& plan, const float* linear,
                      std::size_t cells, SurveyBatch& batch,
                      SurveyCallback decide, void* context) {
  const std::size_t lanes = hn::Lanes(SurveyFloats());
  const auto samples =
      static_cast<std::size_t>(plan.bands.width * plan.bands.height);
  const std::size_t values = kChannels * samples;
  std::size_t cell = 0;
  for (; cell + lanes <= cells; cell += lanes) {
    const float* const first = linear + cell * values;
    SampleReader(plan, first, batch).Read();
    if (cell + 2 * lanes <= cells)
      Expect(first + lanes * values, lanes * values);
    CandidateSurvey(plan, batch).Run();
    decide(context, cell, lanes);
  }
  return cell;
}

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace rtb
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rtb {

HWY_EXPORT(SurveyAll);

SurveyBatch::SurveyBatch(const SurveyPlan& plan) {
  const auto samples =
      static_cast<std::size_t>(plan.bands.width * plan.bands.height);
  const std::size_t candidates = plan.candidates.size();
  if (plan.has_pixels) pixels.resize(3 * samples * stride);
  mean.resize(3 * stride);
  rest.resize(3 * stride);
  bands.resize(3 * static_cast<std::size_t>(plan.bands.count()) * stride);
  sums.resize(3 * candidates * stride);
  errors.resize(candidates * stride);
  for (auto* values : {&spread, &least, &second}) values->resize(stride);
  chosen.resize(stride);
}

std::size_t SurveyCells(const SurveyPlan& plan, std::span<const Rgb> linear,
                        std::size_t cells, SurveyBatch& batch,
                        SurveyCallback decide, void* context) {
  const auto samples =
      static_cast<std::size_t>(plan.bands.width * plan.bands.height);
  RTB_CHECK_EQ(linear.size(), cells * samples);
  if (cells == 0) return 0;
  return HWY_DYNAMIC_DISPATCH(SurveyAll)(plan, &linear[0].x, cells, batch,
                                         decide, context);
}

}  // namespace rtb
#endif  // HWY_ONCE
