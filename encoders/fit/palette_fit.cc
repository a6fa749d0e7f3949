#include "encoders/fit/palette_fit.h"

#include <limits>
#include <utility>

#include "core/base/check.h"
#include "encoders/fit/channel_fit.h"
#include "encoders/fit/choose.h"
#include "encoders/fit/color_fit.h"

namespace rtb {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// An entry of the palette, and its squared distance from what was wanted.
struct Nearest {
  std::size_t index = 0;
  double distance = kInfinity;
};

Nearest FindNearest(std::span<const V3d> values, const V3d& wanted) {
  Nearest nearest;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double distance = (values[i] - wanted).length2();
    if (distance < nearest.distance) nearest = {i, distance};
  }
  return nearest;
}

/// Indices of two entries, and the error that they leave.
struct EntryPair {
  std::size_t fg = 0;
  std::size_t bg = 0;
  double error = kInfinity;
};

/// Finds the pair of entries for a mask whose sub-pixels mix the two colors.
/// For each entry as the outer color the inner one is the entry nearest to the
/// best color beside it. An outer color leaves at least
///   least + curvature |outer - best outer|^2,
/// whatever the inner one; few entries come below the best pair found.
class MixedSearch {
 public:
  MixedSearch(const FitMask& mask, const CenteredSamples& samples,
              const V3d& correlation, std::span<const V3d> values)
      : cost_(mask, 0),
        correlation_(correlation),
        mean_(samples.mean),
        least_(LeastError(mask, samples, correlation)),
        values_(values) {
    for (int c = 0; c < 3; ++c) {
      const ValuePair pair = SolvePair(mask, correlation[c]);
      best_fg_[c] = pair.fg + mean_[c];
      best_bg_[c] = pair.bg + mean_[c];
    }
    // The outer color is that of less weight: the bound rises faster.
    swapped_ = cost_.aa > cost_.bb;
    if (swapped_) Swap();
    curvature_ = mask.size() * mask.variance / cost_.bb;
  }

  EntryPair Run() {
    Try(FindNearest(values_, best_fg_).index);
    for (std::size_t outer = 0; outer < values_.size(); ++outer) {
      if (BoundOf(outer) < best_.error) Try(outer);
    }
    if (swapped_) std::swap(best_.fg, best_.bg);
    return best_;
  }

 private:
  void Swap() {
    cost_ = cost_.Swapped();
    correlation_ = -correlation_;
    std::swap(best_fg_, best_bg_);
  }

  double BoundOf(std::size_t outer) const {
    return least_ + curvature_ * (values_[outer] - best_fg_).length2();
  }

  void Try(std::size_t outer) {
    V3d wanted(0);
    for (int c = 0; c < 3; ++c) {
      PairCost cost = cost_;
      cost.p = correlation_[c];
      wanted[c] = cost.BestBg(values_[outer][c] - mean_[c]) + mean_[c];
    }
    const Nearest inner = FindNearest(values_, wanted);
    const double error = BoundOf(outer) + cost_.bb * inner.distance;
    if (error < best_.error) best_ = {outer, inner.index, error};
  }

  PairCost cost_;
  V3d correlation_;
  V3d mean_;
  double least_;
  std::span<const V3d> values_;
  V3d best_fg_{0};
  V3d best_bg_{0};
  bool swapped_ = false;
  double curvature_ = 0;
  EntryPair best_;
};

/// Each color counts by itself: the nearest entry to its best value.
EntryPair FindApart(const FitMask& mask, const CenteredSamples& samples,
                    const V3d& correlation, std::span<const V3d> values) {
  V3d fg(0);
  V3d bg(0);
  for (int c = 0; c < 3; ++c) {
    const ValuePair pair = SolvePair(mask, correlation[c]);
    fg[c] = pair.fg + samples.mean[c];
    bg[c] = pair.bg + samples.mean[c];
  }
  EntryPair pair;
  if (mask.sum > 0) pair.fg = FindNearest(values, fg).index;
  if (mask.sum < mask.size()) pair.bg = FindNearest(values, bg).index;
  if (mask.sum == 0) pair.fg = pair.bg;
  if (mask.sum == mask.size()) pair.bg = pair.fg;
  return pair;
}

CellFit FinishMask(const FitMask& mask, int candidate,
                   const FitPalette& palette, const CenteredSamples& samples,
                   const V3d& correlation) {
  const auto values = palette.values();
  const EntryPair pair =
      mask.binary() ? FindApart(mask, samples, correlation, values)
                    : MixedSearch(mask, samples, correlation, values).Run();
  const double error = ErrorOfPair(mask, samples, correlation,
                                   {values[pair.fg], values[pair.bg]});
  const auto colors = palette.colors();
  return {{mask.glyph, colors[pair.fg], colors[pair.bg]}, error, candidate};
}

}  // namespace

FitPalette::FitPalette(Blend blend, std::span<const Rgb8> colors)
    : blend_(blend), colors_(colors.begin(), colors.end()) {
  RTB_CHECK(!colors_.empty());
  for (const Rgb8& color : colors_) values_.push_back(FromRgb8(blend, color));
}

CellFit FitCellToPalette(const Atlas& atlas, const FitPalette& palette,
                         std::span<const V3d> samples) {
  const CenteredSamples centered = Center(samples);
  const std::vector<Prospect> prospects = Survey(atlas, centered);
  return ChooseBest(prospects, [&](std::size_t i) {
    return FinishMask(atlas.candidates()[i], static_cast<int>(i), palette,
                      centered, prospects[i].correlation);
  });
}

CellFit RefitToPalette(const FitMask& mask, const FitPalette& palette,
                       std::span<const V3d> samples) {
  const CenteredSamples centered = Center(samples);
  return FinishMask(mask, 0, palette, centered, Correlate(mask, centered));
}

CellFit FitCellToColors(const Atlas& atlas, Blend blend,
                        std::span<const V3d> samples, Rgb8 fg, Rgb8 bg) {
  const CenteredSamples centered = Center(samples);
  const ColorPair colors = {FromRgb8(blend, fg), FromRgb8(blend, bg)};
  // With the colors fixed, a complement is as good a candidate as any.
  std::vector<Prospect> prospects;
  for (const FitMask& mask : atlas.candidates()) {
    const V3d correlation = Correlate(mask, centered);
    prospects.push_back(
        {correlation, ErrorOfPair(mask, centered, correlation, colors)});
  }
  return ChooseBest(prospects, [&](std::size_t i) {
    return CellFit{{atlas.candidates()[i].glyph, fg, bg},
                   prospects[i].least,
                   static_cast<int>(i)};
  });
}

}  // namespace rtb
