#include "encoders/fit/channel_fit.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "core/base/check.h"

namespace rtb {
namespace {

using Values = std::span<const double, 256>;

/// Gains below this are rounding errors of double precision.
constexpr double kNoGain = kNoise * kNoise;

/// The largest code but 255 whose value is at most `value`; 0 below all.
int CodeBelow(Values values, double value) {
  const auto above = std::upper_bound(values.begin(), values.end() - 1, value);
  return std::max(0, static_cast<int>(above - values.begin()) - 1);
}

/// The nearest code, of two the upper one.
int NearestCode(Values values, double value) {
  const int below = CodeBelow(values, value);
  const auto at = static_cast<std::size_t>(below);
  const double middle = (values[at] + values[at + 1]) / 2;
  return value + kNoise >= middle ? below + 1 : below;
}

/// Walks through the codes of the outer value (`cost`'s fg), and takes the
/// best inner one beside each. What the best inner value leaves is a convex
/// function of the outer one, so that each direction ends where it exceeds
/// the best pair found.
class CodeWalk {
 public:
  CodeWalk(const PairCost& cost, Values values, double mean)
      : cost_(cost), values_(values), mean_(mean) {
    best_.cost = std::numeric_limits<double>::infinity();
  }

  CodePair From(double outer) {
    const int below = CodeBelow(values_, outer + mean_);
    for (int code = below + 1; code < 256 && Try(code); ++code) {
    }
    for (int code = below; code >= 0 && Try(code); --code) {
    }
    return best_;
  }

 private:
  double Value(int code) const {
    return values_[static_cast<std::size_t>(code)] - mean_;
  }

  /// False when no code further on can be better.
  bool Try(int outer) {
    const double fg = Value(outer);
    const double bg = std::clamp(cost_.BestBg(fg), Value(0), Value(255));
    if (cost_.At(fg, bg) >= best_.cost) return false;
    const int below = CodeBelow(values_, bg + mean_);
    for (const int inner : {below + 1, below}) {
      const double cost = cost_.At(fg, Value(inner));
      if (cost < best_.cost - kNoGain) best_ = {outer, inner, cost};
    }
    return true;
  }

  PairCost cost_;
  Values values_;
  double mean_;
  CodePair best_;
};

/// The two colors count by themselves.
CodePair RoundBoth(const FitMask& mask, const PairCost& cost, Values values,
                   double mean) {
  const ValuePair pair = SolvePair(mask, cost.p);
  CodePair codes;
  if (cost.aa > 0) codes.fg = NearestCode(values, pair.fg + mean);
  if (cost.bb > 0) codes.bg = NearestCode(values, pair.bg + mean);
  const auto value = [&](int code) {
    return values[static_cast<std::size_t>(code)] - mean;
  };
  codes.cost = cost.At(value(codes.fg), value(codes.bg));
  return codes;
}

std::array<double, 256> MakeCodeValues(Blend blend) {
  std::array<double, 256> values;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto code = static_cast<std::uint8_t>(i);
    values[i] = FromRgb8(blend, {code, code, code}).x;
  }
  return values;
}

}  // namespace

ValuePair SolvePair(const FitMask& mask, double correlation) {
  if (mask.constant()) return {0, 0};
  const double difference = correlation / mask.variance;
  const double bg = -difference * mask.sum / mask.size();
  return {bg + difference, bg};
}

ValuePair SolvePairWithin(const FitMask& mask, double correlation, double low,
                          double high) {
  const auto outside = [&](double v) { return v < low || v > high; };
  const ValuePair free = SolvePair(mask, correlation);
  const PairCost cost(mask, correlation);
  ValuePair best = free;
  double least = std::numeric_limits<double>::infinity();
  if (outside(free.fg)) {
    const double fg = std::clamp(free.fg, low, high);
    best = {fg, std::clamp(cost.BestBg(fg), low, high)};
    least = cost.At(best.fg, best.bg);
  }
  if (outside(free.bg)) {
    const double bg = std::clamp(free.bg, low, high);
    const ValuePair pair = {std::clamp(cost.Swapped().BestBg(bg), low, high),
                            bg};
    if (cost.At(pair.fg, pair.bg) < least) best = pair;
  }
  return best;
}

CodePair BestCodes(const FitMask& mask, double correlation,
                   std::span<const double, 256> values, double mean) {
  const PairCost cost(mask, correlation);
  if (mask.binary()) return RoundBoth(mask, cost, values, mean);
  const ValuePair start = SolvePairWithin(
      mask, correlation, values.front() - mean, values.back() - mean);
  // Walking along the color of less weight takes fewer steps: those within
  // half a code of the other one, as the ellipse of equal cost is long.
  if (cost.bb <= cost.aa) return CodeWalk(cost, values, mean).From(start.fg);
  CodePair codes = CodeWalk(cost.Swapped(), values, mean).From(start.bg);
  std::swap(codes.fg, codes.bg);
  return codes;
}

std::span<const double, 256> CodeValues(Blend blend) {
  static const auto srgb = MakeCodeValues(Blend::kSrgb);
  static const auto linear = MakeCodeValues(Blend::kLinear);
  RTB_CHECK(blend != Blend::kOklab);
  return blend == Blend::kSrgb ? srgb : linear;
}

}  // namespace rtb
