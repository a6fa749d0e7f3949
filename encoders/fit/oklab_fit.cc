#include "encoders/fit/oklab_fit.h"

#include <algorithm>
#include <array>

#include "core/color/oklab.h"
#include "encoders/fit/channel_fit.h"

namespace rtb {
namespace {

/// Channels of a color that a step changes by -1, 0 or 1.
using Step = std::array<int, 3>;

/// All 27 steps, that of length 0 among them.
constexpr std::array<Step, 27> kSteps = [] {
  std::array<Step, 27> steps{};
  for (int i = 0; i < 27; ++i) {
    steps[static_cast<std::size_t>(i)] = {i / 9 - 1, i / 3 % 3 - 1, i % 3 - 1};
  }
  return steps;
}();

std::uint8_t Stepped(std::uint8_t code, int step) {
  return static_cast<std::uint8_t>(std::clamp(code + step, 0, 255));
}

Rgb8 Stepped(Rgb8 color, const Step& step) {
  return {Stepped(color.r, step[0]), Stepped(color.g, step[1]),
          Stepped(color.b, step[2])};
}

/// The nearest displayable color, as clipping in linear light finds it.
V3d Clamped(const V3d& lab) {
  V3d linear = OklabToLinear(lab);
  for (int c = 0; c < 3; ++c) linear[c] = std::clamp(linear[c], 0.0, 1.0);
  return LinearToOklab(linear);
}

bool Displayable(const V3d& lab) {
  const V3d linear = OklabToLinear(lab);
  const auto inside = [](double v) { return v >= -kNoise && v <= 1 + kNoise; };
  return inside(linear.x) && inside(linear.y) && inside(linear.z);
}

/// The pair's error as a function of display colors.
class OklabCost {
 public:
  OklabCost(const FitMask& mask, const CenteredSamples& samples,
            const V3d& correlation)
      : mask_(mask), samples_(samples), correlation_(correlation) {}

  double At(const ColorPair& colors) const {
    return ErrorOfPair(mask_, samples_, correlation_, colors);
  }

  /// The best other color beside one that is fixed, displayable.
  V3d BestFg(const V3d& bg) const {
    V3d fg(0);
    for (int c = 0; c < 3; ++c) {
      fg[c] = Cost(c).Swapped().BestBg(bg[c] - Mean(c)) + Mean(c);
    }
    return Clamped(fg);
  }
  V3d BestBg(const V3d& fg) const {
    V3d bg(0);
    for (int c = 0; c < 3; ++c) {
      bg[c] = Cost(c).BestBg(fg[c] - Mean(c)) + Mean(c);
    }
    return Clamped(bg);
  }

 private:
  PairCost Cost(int c) const { return {mask_, correlation_[c]}; }
  double Mean(int c) const { return samples_.mean[c]; }

  const FitMask& mask_;
  const CenteredSamples& samples_;
  const V3d& correlation_;
};

/// A descent over pairs of codes.
class CodeDescent {
 public:
  CodeDescent(const FitMask& mask, const OklabCost& cost, const Rgb8& fg,
              const Rgb8& bg)
      : has_fg_(mask.sum > 0),
        has_bg_(mask.sum < mask.size()),
        apart_(mask.binary()),
        cost_(cost) {
    best_ = {has_fg_ ? fg : Rgb8{}, has_bg_ ? bg : Rgb8{}, 0};
    best_.error = ErrorOf(best_.fg, best_.bg);
  }

  CodesFit Run() {
    for (bool better = true; better;) {
      const CodesFit center = best_;
      better = false;
      for (const Step& step : kSteps) {
        const Rgb8 fg = Stepped(center.fg, step);
        const Rgb8 bg = Stepped(center.bg, step);
        if (has_fg_) better |= Try(fg, center.bg);
        if (has_bg_) better |= Try(center.fg, bg);
        if (apart_) continue;
        const Step back = {-step[0], -step[1], -step[2]};
        better |= Try(fg, bg);
        better |= Try(fg, Stepped(center.bg, back));
      }
    }
    return best_;
  }

 private:
  double ErrorOf(Rgb8 fg, Rgb8 bg) const {
    return cost_.At({FromRgb8(Blend::kOklab, fg), FromRgb8(Blend::kOklab, bg)});
  }

  bool Try(Rgb8 fg, Rgb8 bg) {
    if (fg == best_.fg && bg == best_.bg) return false;
    const double error = ErrorOf(fg, bg);
    if (error >= best_.error - kNoise * kNoise) return false;
    best_ = {fg, bg, error};
    return true;
  }

  bool has_fg_;
  bool has_bg_;
  bool apart_;
  const OklabCost& cost_;
  CodesFit best_;
};

}  // namespace

ColorPair SolveOklab(const FitMask& mask, const CenteredSamples& samples,
                     const V3d& correlation) {
  ColorPair free;
  for (int c = 0; c < 3; ++c) {
    const ValuePair pair = SolvePair(mask, correlation[c]);
    free.fg[c] = pair.fg + samples.mean[c];
    free.bg[c] = pair.bg + samples.mean[c];
  }
  const bool fg_outside = !Displayable(free.fg);
  const bool bg_outside = !Displayable(free.bg);
  if (!fg_outside && !bg_outside) return free;
  const OklabCost cost(mask, samples, correlation);
  const V3d fg = Clamped(free.fg);
  const V3d bg = Clamped(free.bg);
  const ColorPair fg_first = {fg, cost.BestBg(fg)};
  const ColorPair bg_first = {cost.BestFg(bg), bg};
  if (!bg_outside) return fg_first;
  if (!fg_outside) return bg_first;
  return cost.At(fg_first) <= cost.At(bg_first) ? fg_first : bg_first;
}

CodesFit SolveOklabCodes(const FitMask& mask, const CenteredSamples& samples,
                         const V3d& correlation) {
  const ColorPair start = SolveOklab(mask, samples, correlation);
  const OklabCost cost(mask, samples, correlation);
  return CodeDescent(mask, cost, ToRgb8(Blend::kOklab, start.fg),
                     ToRgb8(Blend::kOklab, start.bg))
      .Run();
}

}  // namespace rtb
