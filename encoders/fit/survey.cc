#include "encoders/fit/survey.h"

#include "core/base/check.h"

// This file is compiled once for each target.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "encoders/fit/survey.cc"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/color/srgb-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rtb {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using SurveyFloats = hn::CappedTag<float, SurveyBatch::stride>;
using SurveyInts = hn::RebindToSigned<SurveyFloats>;
using F = hn::Vec<SurveyFloats>;
using I = hn::Vec<SurveyInts>;

constexpr std::size_t kStride = SurveyBatch::stride;
constexpr std::size_t kChannels = 3;

HWY_INLINE I LoadInts(const std::vector<std::int32_t>& values, std::size_t i) {
  return hn::LoadU(SurveyInts(), values.data() + i * kStride);
}
HWY_INLINE void Put(I v, std::vector<std::int32_t>& values, std::size_t i) {
  hn::StoreU(v, SurveyInts(), values.data() + i * kStride);
}
HWY_INLINE F LoadFloats(const std::vector<float>& values, std::size_t i) {
  return hn::LoadU(SurveyFloats(), values.data() + i * kStride);
}
HWY_INLINE void Put(F v, std::vector<float>& values, std::size_t i) {
  hn::StoreU(v, SurveyFloats(), values.data() + i * kStride);
}
HWY_INLINE F ToFloats(I v) { return hn::ConvertTo(SurveyFloats(), v); }
HWY_INLINE F Same(float v) { return hn::Set(SurveyFloats(), v); }
HWY_INLINE I Same(int v) { return hn::Set(SurveyInts(), v); }

/// One vector for each channel.
template <class V>
struct Channels {
  V r, g, b;
};

/// The samples of a batch of cells in steps, read, stored and summed.
class SampleReader {
 public:
  HWY_INLINE SampleReader(const SurveyPlan& plan, const float* linear,
                          SurveyBatch& batch)
      : bands_(plan.bands), linear_(linear), batch_(batch) {}

  HWY_INLINE void Read() {
    const int samples = bands_.width * bands_.height;
    cell_ = hn::Mul(hn::Iota(SurveyInts(), 0),
                    Same(static_cast<int>(kChannels) * samples));
    for (int x = 0; x < bands_.width; ++x) {
      for (std::size_t c = 0; c < kChannels; ++c) {
        Put(Same(0), batch_.bands, BandAt(bands_.column(x), c));
      }
    }
    F spread = Same(0.0f);
    for (std::size_t c = 0; c < kChannels; ++c) {
      spread = hn::Add(spread, ReadChannel(c));
    }
    // Values in a range of width w are w^2 / 4 from their mean at most, in the
    // mean of the squares.
    Put(hn::Mul(spread, Same(0.25f * static_cast<float>(samples))),
        batch_.spread, 0);
  }

 private:
  static HWY_INLINE std::size_t BandAt(int band, std::size_t c) {
    return kChannels * static_cast<std::size_t>(band) + c;
  }

  HWY_INLINE I ReadSample(std::size_t value) {
    const SurveyFloats d;
    const F linear = hn::GatherIndex(d, linear_ + value, cell_);
    const F encoded = SrgbCurveOf(d, linear, table_);
    const I steps =
        hn::NearestInt(hn::Mul(encoded, Same(static_cast<float>(kWhiteSteps))));
    Put(steps, batch_.steps, value);
    return steps;
  }

  /// Squared range of one channel, in codes.
  HWY_INLINE F ReadChannel(std::size_t c) {
    I total = Same(0);
    low_ = Same(kWhiteSteps);
    high_ = Same(0);
    for (int y = 0; y < bands_.height; ++y) {
      const I left = ReadHalf(y, 0, bands_.middle(), c);
      const I right = ReadHalf(y, bands_.middle(), bands_.width, c);
      Put(left, batch_.bands, BandAt(2 * y, c));
      Put(right, batch_.bands, BandAt(2 * y + 1, c));
      total = hn::Add(total, hn::Add(left, right));
    }
    Center(total, c);
    const F range =
        hn::Mul(ToFloats(hn::Sub(high_, low_)), Same(1.0f / kStepsPerCode));
    return hn::Mul(range, range);
  }

  HWY_INLINE I ReadHalf(int y, int begin, int end, std::size_t c) {
    I sum = Same(0);
    for (int x = begin; x < end; ++x) {
      const auto sample = static_cast<std::size_t>(y * bands_.width + x);
      const I steps = ReadSample(kChannels * sample + c);
      sum = hn::Add(sum, steps);
      low_ = hn::Min(low_, steps);
      high_ = hn::Max(high_, steps);
      const std::size_t column = BandAt(bands_.column(x), c);
      Put(hn::Add(LoadInts(batch_.bands, column), steps), batch_.bands, column);
    }
    return sum;
  }

  /// Takes the mean off the bands: all exact, as sums are below 2^28.
  HWY_INLINE void Center(I total, std::size_t c) {
    const int samples = bands_.width * bands_.height;
    const F share = Same(1.0f / static_cast<float>(samples));
    const I mean = hn::NearestInt(hn::Mul(ToFloats(total), share));
    Put(mean, batch_.mean, c);
    Put(hn::Sub(total, hn::Mul(mean, Same(samples))), batch_.rest, c);
    const auto take_off = [&](int band, int count) HWY_ATTR {
      const std::size_t at = BandAt(band, c);
      Put(hn::Sub(LoadInts(batch_.bands, at), hn::Mul(mean, Same(count))),
          batch_.bands, at);
    };
    for (int y = 0; y < bands_.height; ++y) {
      take_off(2 * y, bands_.middle());
      take_off(2 * y + 1, bands_.width - bands_.middle());
    }
    for (int x = 0; x < bands_.width; ++x) {
      take_off(bands_.column(x), bands_.height);
    }
  }

  const SurveyBands bands_;
  const float* linear_;
  SurveyBatch& batch_;
  const SrgbCurveTable& table_ = SrgbCurve();
  I cell_ = Same(0);
  I low_ = Same(0);
  I high_ = Same(0);
};

/// Samples less the mean, as floats: whole numbers below 2^21.
HWY_INLINE void CenterPixels(int samples, SurveyBatch& batch) {
  for (std::size_t c = 0; c < kChannels; ++c) {
    const I mean = LoadInts(batch.mean, c);
    for (std::size_t s = 0; s < static_cast<std::size_t>(samples); ++s) {
      const std::size_t at = kChannels * s + c;
      Put(ToFloats(hn::Sub(LoadInts(batch.steps, at), mean)), batch.pixels, at);
    }
  }
}

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
    const auto mean = [&](std::size_t c, F r) HWY_ATTR {
      const F whole = ToFloats(LoadInts(batch.mean, c));
      return hn::Mul(hn::MulAdd(r, Same(1 / samples), whole),
                     Same(1.0f / kStepsPerCode));
    };
    mean_ = {mean(0, rest_.r), mean(1, rest_.g), mean(2, rest_.b)};
    spread_ = LoadFloats(batch.spread, 0);
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
    return hn::NegMulAdd(Same(candidate.slack), spread_, error);
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
    Channels<I> sum = {Same(0), Same(0), Same(0)};
    if (candidate.parent >= 0) {
      sum = LoadTriple(batch_.sums, static_cast<std::size_t>(candidate.parent));
    }
    for (std::size_t t = candidate.first_term; t < candidate.end_term; ++t) {
      const SurveyTerm& term = plan_.terms[t];
      const Channels<I> band =
          LoadTriple(batch_.bands, static_cast<std::size_t>(term.index));
      if (term.weight > 0) {
        sum = {hn::Add(sum.r, band.r), hn::Add(sum.g, band.g),
               hn::Add(sum.b, band.b)};
      } else {
        sum = {hn::Sub(sum.r, band.r), hn::Sub(sum.g, band.g),
               hn::Sub(sum.b, band.b)};
      }
    }
    Put(sum.r, batch_.sums, kChannels * i);
    Put(sum.g, batch_.sums, kChannels * i + 1);
    Put(sum.b, batch_.sums, kChannels * i + 2);
    return {ToFloats(sum.r), ToFloats(sum.g), ToFloats(sum.b)};
  }

  static HWY_INLINE Channels<I> LoadTriple(
      const std::vector<std::int32_t>& values, std::size_t i) {
    return {LoadInts(values, kChannels * i),
            LoadInts(values, kChannels * i + 1),
            LoadInts(values, kChannels * i + 2)};
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
  Channels<F> mean_;  ///< In codes.
  F spread_;
};

std::size_t SurveyAll(const SurveyPlan& plan, const float* linear,
                      std::size_t cells, SurveyBatch& batch,
                      SurveyCallback decide, void* context) {
  const std::size_t lanes = hn::Lanes(SurveyFloats());
  const int samples = plan.bands.width * plan.bands.height;
  const std::size_t values = kChannels * static_cast<std::size_t>(samples);
  std::size_t cell = 0;
  for (; cell + lanes <= cells; cell += lanes) {
    SampleReader(plan, linear + cell * values, batch).Read();
    if (plan.has_pixels) CenterPixels(samples, batch);
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
  steps.resize(3 * samples * stride);
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
