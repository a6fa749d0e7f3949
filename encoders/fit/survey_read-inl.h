/// @file
/// How a survey reads samples: linear light to steps, summed over bands. For
/// inclusion per target (Highway).

// Highway's guard, which flips with each target, in place of #pragma once.
#if defined(RTB_ENCODERS_FIT_SURVEY_READ_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTB_ENCODERS_FIT_SURVEY_READ_INL_H_
#undef RTB_ENCODERS_FIT_SURVEY_READ_INL_H_
#else
#define RTB_ENCODERS_FIT_SURVEY_READ_INL_H_
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <cstddef>

#include "core/color/srgb-inl.h"
#include "encoders/fit/survey_lanes-inl.h"
#include "encoders/simd/transpose-inl.h"
#include "encoders/steps.h"

HWY_BEFORE_NAMESPACE();
namespace rtb {
namespace HWY_NAMESPACE {

/// The samples of a batch of cells in steps, read, kept and summed.
class SampleReader {
 public:
  HWY_INLINE SampleReader(const SurveyPlan& plan, const float* linear,
                          SurveyBatch& batch)
      : bands_(plan.bands),
        samples_(plan.bands.width * plan.bands.height),
        keeps_(plan.has_pixels),
        linear_(linear),
        batch_(batch) {}

  HWY_INLINE void Read() {
    cell_ = hn::Mul(hn::Iota(SurveyInts(), 0),
                    Same(static_cast<int>(kChannels) * samples_));
    for (int x = 0; x < bands_.width; ++x) {
      PutTriple(SameInAll(0), batch_.bands, ColumnAt(x));
    }
    Channels<I> total = SameInAll(0);
    for (int y = 0; y < bands_.height; ++y) {
      const auto row = 2 * static_cast<std::size_t>(y);
      const Channels<I> left = ReadHalf(y, 0, bands_.middle());
      const Channels<I> right = ReadHalf(y, bands_.middle(), bands_.width);
      PutTriple(left, batch_.bands, row);
      PutTriple(right, batch_.bands, row + 1);
      total = total + left + right;
    }
    Center(total);
    // Values in a range of width w are w^2 / 4 from their mean at most, in the
    // mean of the squares.
    const F squares = hn::Add(
        hn::Add(SquaredRange(low_.r, high_.r), SquaredRange(low_.g, high_.g)),
        SquaredRange(low_.b, high_.b));
    Put(hn::Mul(squares, Same(0.25f * static_cast<float>(samples_))),
        batch_.spread, 0);
  }

 private:
  HWY_INLINE std::size_t ColumnAt(int x) const {
    return static_cast<std::size_t>(bands_.column(x));
  }

  HWY_INLINE I StepsOf(F linear) const {
    const F encoded = SrgbCurveOf(SurveyFloats(), linear, table_);
    return hn::NearestInt(
        hn::Mul(encoded, Same(static_cast<float>(kWhiteSteps))));
  }

  /// Samples that are read together: 12 floats of a cell side by side are
  /// turned into lanes by shuffles, at a fraction of what gathers take.
  static constexpr int kTogether = 4;
  static constexpr std::size_t kMostValues = kChannels * kTogether;

  /// `count` floats of each cell from `at` on, one a vector.
  HWY_INLINE void Load(std::size_t at, std::size_t count,
                       F (&values)[kMostValues]) const {
    const SurveyFloats d;
#if HWY_TARGET != HWY_SCALAR
    constexpr std::size_t kBlock = 4;
    if (count >= kBlock) {
      const std::size_t stride = kChannels * static_cast<std::size_t>(samples_);
      for (std::size_t i = 0; i < count; i += kBlock) {
        // The last block reaches back instead of beyond the end.
        const std::size_t begin = std::min(i, count - kBlock);
        F columns[kBlock];
        LoadFour(d, linear_ + at + begin, stride, columns);
        for (std::size_t j = i - begin; j < kBlock; ++j) {
          values[begin + j] = columns[j];
        }
      }
      return;
    }
#endif
    for (std::size_t i = 0; i < count; ++i) {
      values[i] = hn::GatherIndex(d, linear_ + at + i, cell_);
    }
  }

  HWY_INLINE Channels<I> ReadHalf(int y, int begin, int end) {
    Channels<I> sum = SameInAll(0);
    int x = begin;
    for (; x + kTogether <= end; x += kTogether) {
      ReadSamples<kTogether>(y, x, sum);
    }
    if (end - x == 3) ReadSamples<3>(y, x, sum);
    if (end - x == 2) ReadSamples<2>(y, x, sum);
    if (end - x == 1) ReadSamples<1>(y, x, sum);
    return sum;
  }

  /// kCount samples of a row from column x on.
  template <int kCount>
  HWY_INLINE void ReadSamples(int y, int x, Channels<I>& sum) {
    const std::size_t first =
        kChannels * static_cast<std::size_t>(y * bands_.width + x);
    F values[kMostValues];
    Load(first, kChannels * kCount, values);
    for (int i = 0; i < kCount; ++i) {
      const std::size_t v = kChannels * static_cast<std::size_t>(i);
      const Channels<I> steps = {StepsOf(values[v]), StepsOf(values[v + 1]),
                                 StepsOf(values[v + 2])};
      if (keeps_) Keep(steps, first + v);
      sum = sum + steps;
      low_ = {hn::Min(low_.r, steps.r), hn::Min(low_.g, steps.g),
              hn::Min(low_.b, steps.b)};
      high_ = {hn::Max(high_.r, steps.r), hn::Max(high_.g, steps.g),
               hn::Max(high_.b, steps.b)};
      PutTriple(LoadTriple(batch_.bands, ColumnAt(x + i)) + steps, batch_.bands,
                ColumnAt(x + i));
    }
  }

  HWY_INLINE void Keep(const Channels<I>& steps, std::size_t at) {
    Put(ToFloats(steps.r), batch_.pixels, at);
    Put(ToFloats(steps.g), batch_.pixels, at + 1);
    Put(ToFloats(steps.b), batch_.pixels, at + 2);
  }

  static HWY_INLINE F SquaredRange(I low, I high) {
    const F range =
        hn::Mul(ToFloats(hn::Sub(high, low)), Same(1.0f / kStepsPerCode));
    return hn::Mul(range, range);
  }

  HWY_INLINE I MeanOf(I total) const {
    return hn::NearestInt(
        hn::Mul(ToFloats(total), Same(1.0f / static_cast<float>(samples_))));
  }

  /// Takes the mean off what was summed: all exact, as sums are below 2^28.
  HWY_INLINE void Center(const Channels<I>& total) {
    const Channels<I> mean = {MeanOf(total.r), MeanOf(total.g),
                              MeanOf(total.b)};
    PutTriple(mean, batch_.mean, 0);
    PutTriple(total - mean * samples_, batch_.rest, 0);
    for (int y = 0; y < bands_.height; ++y) {
      TakeOff(mean * bands_.middle(), 2 * y);
      TakeOff(mean * (bands_.width - bands_.middle()), 2 * y + 1);
    }
    for (int x = 0; x < bands_.width; ++x) {
      TakeOff(mean * bands_.height, bands_.column(x));
    }
    if (!keeps_) return;
    const Channels<F> shift = {ToFloats(mean.r), ToFloats(mean.g),
                               ToFloats(mean.b)};
    const auto values = kChannels * static_cast<std::size_t>(samples_);
    for (std::size_t at = 0; at < values; at += kChannels) {
      const auto move = [&](std::size_t i, F by) HWY_ATTR {
        Put(hn::Sub(LoadFloats(batch_.pixels, i), by), batch_.pixels, i);
      };
      move(at, shift.r);
      move(at + 1, shift.g);
      move(at + 2, shift.b);
    }
  }

  HWY_INLINE void TakeOff(const Channels<I>& sum, int band) {
    const auto at = static_cast<std::size_t>(band);
    PutTriple(LoadTriple(batch_.bands, at) - sum, batch_.bands, at);
  }

  const SurveyBands bands_;
  const int samples_;
  const bool keeps_;
  const float* linear_;
  SurveyBatch& batch_;
  const SrgbCurveTable& table_ = SrgbCurve();
  I cell_ = Same(0);
  Channels<I> low_ = SameInAll(kWhiteSteps);
  Channels<I> high_ = SameInAll(0);
};

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace rtb
HWY_AFTER_NAMESPACE();

#endif  // RTB_ENCODERS_FIT_SURVEY_READ_INL_H_
