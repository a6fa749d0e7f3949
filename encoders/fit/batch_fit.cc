#include "encoders/fit/batch_fit.h"

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "core/base/check.h"
#include "encoders/fit/choose.h"
#include "encoders/fit/color_fit.h"
#include "encoders/fit/fit.h"
#include "encoders/fit/survey.h"
#include "encoders/steps.h"

namespace rtb {
namespace {

constexpr std::size_t kChannels = 3;

/// FitCell for one cell of linear samples.
Cell FitLinear(const Atlas& atlas, std::span<const Rgb> linear) {
  std::vector<V3d> samples(linear.size());
  ToBlend(Blend::kSrgb, linear, samples);
  return FitCell(atlas, Blend::kSrgb, samples).cell;
}

/// Decides the cells of one batch after the other.
class BatchDecider {
 public:
  BatchDecider(const Atlas& atlas, const SurveyPlan& plan,
               std::span<Cell> cells)
      : atlas_(atlas),
        plan_(plan),
        cells_(cells),
        samples_(static_cast<std::size_t>(atlas.width() * atlas.height())),
        batch_(plan) {}

  SurveyBatch& batch() { return batch_; }

  static void Decide(void* context, std::size_t first, std::size_t lanes) {
    auto& decider = *static_cast<BatchDecider*>(context);
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      decider.cells_[first + lane] = decider.DecideLane(lane);
    }
  }

 private:
  /// The mean of a channel, in steps.
  double MeanOf(std::size_t channel, std::size_t lane) const {
    const std::size_t at = channel * SurveyBatch::stride + lane;
    return batch_.mean[at] + batch_.rest[at] / Size();
  }

  double Size() const { return static_cast<double>(samples_.size()); }

  Cell DecideLane(std::size_t lane) {
    Cell cell;
    const bool decided = batch_.spread[lane] == 0 ? DecideFlat(lane, cell)
                                                  : DecideByBounds(lane, cell);
    return decided ? cell : Finish(lane);
  }

  /// A code for a value in steps. False when it is so near to a middle that
  /// rounding errors of double precision might decide.
  static bool CodeOf(double steps, std::uint8_t& code) {
    const double value = (steps / kWhiteSteps + kNoise) * 255 + 0.5;
    code = static_cast<std::uint8_t>(value);
    return std::abs(value - std::nearbyint(value)) > 1e-9;
  }

  /// One color, so near to a code that a space is best.
  bool DecideFlat(std::size_t lane, Cell& cell) const {
    const auto& steps = batch_.steps;
    std::array<std::uint8_t, kChannels> codes;
    for (std::size_t c = 0; c < kChannels; ++c) {
      const int value = steps[c * SurveyBatch::stride + lane];
      if (!CodeOf(value, codes[c])) return false;
      const double code = static_cast<double>(value) / kStepsPerCode;
      if (std::abs(code - codes[c]) > plan_.flat_limit) return false;
    }
    cell = {atlas_.candidates()[0].glyph, {}, {codes[0], codes[1], codes[2]}};
    return true;
  }

  /// How far two errors of the survey may be apart though FitCell finds the
  /// other order, or a tie: what noise may decide (WithNoise), the kNoise by
  /// which rounding half up reaches, the rounding of colors to single
  /// precision (8e-5 codes), that of p^2 / V. In squared codes.
  double Margin(std::size_t lane) const {
    const double spread = batch_.spread[lane];
    constexpr double kNoiseCodes = kNoise * 255;
    const double rounding = 10 * kNoiseCodes * Size();
    return rounding + kNoiseCodes * std::sqrt(spread) + 4e-6 * spread;
  }

  /// The least error is well below all others, and its colors are clear.
  bool DecideByBounds(std::size_t lane, Cell& cell) const {
    const auto chosen = static_cast<std::size_t>(batch_.chosen[lane]);
    const SurveyCandidate& candidate = plan_.candidates[chosen];
    if (candidate.way != SurveyWay::kDifference) return false;
    if (batch_.second[lane] - batch_.least[lane] <= Margin(lane)) return false;
    const FitMask& mask =
        atlas_.candidates()[static_cast<std::size_t>(candidate.index)];
    std::array<std::uint8_t, kChannels> fg{};
    std::array<std::uint8_t, kChannels> bg{};
    for (std::size_t c = 0; c < kChannels; ++c) {
      const std::size_t at = c * SurveyBatch::stride + lane;
      const double mean = MeanOf(c, lane);
      const double rest = batch_.rest[at] * (mask.sum / Size());
      const double sum =
          batch_.sums[(kChannels * chosen + c) * SurveyBatch::stride + lane] -
          rest;
      const double others = Size() - mask.sum;
      if (mask.sum > 0 && !CodeOf(mean + sum / mask.sum, fg[c])) return false;
      if (others > 0 && !CodeOf(mean - sum / others, bg[c])) return false;
    }
    cell = {mask.glyph, {fg[0], fg[1], fg[2]}, {bg[0], bg[1], bg[2]}};
    return true;
  }

  /// As FitCell, but with the survey's bounds.
  Cell Finish(std::size_t lane) {
    for (std::size_t s = 0; s < samples_.size(); ++s) {
      const auto step = [&](std::size_t c) {
        return batch_.steps[(kChannels * s + c) * SurveyBatch::stride + lane];
      };
      samples_[s] = FromSteps({step(0), step(1), step(2)});
    }
    const CenteredSamples centered = Center(samples_);
    prospects_.assign(atlas_.candidates().size(), Prospect());
    const double margin = Margin(lane);
    for (std::size_t i = 0; i < plan_.candidates.size(); ++i) {
      const double error =
          (batch_.errors[i * SurveyBatch::stride + lane] - margin) /
          (255.0 * 255.0);
      prospects_[static_cast<std::size_t>(plan_.candidates[i].index)].least =
          centered.squares + error;
    }
    const CellFit fit = ChooseBest(prospects_, [&](std::size_t i) {
      const FitMask& mask = atlas_.candidates()[i];
      const CodesFit codes =
          SolveCodes(mask, Blend::kSrgb, centered, Correlate(mask, centered));
      return CellFit{
          {mask.glyph, codes.fg, codes.bg}, codes.error, static_cast<int>(i)};
    });
    return fit.cell;
  }

  const Atlas& atlas_;
  const SurveyPlan& plan_;
  std::span<Cell> cells_;
  std::vector<V3d> samples_;
  std::vector<Prospect> prospects_;
  SurveyBatch batch_;
};

}  // namespace

BatchFit::BatchFit(const Atlas& atlas) : atlas_(atlas) {
  if (atlas.width() * atlas.height() <= SurveyPlan::kMaxSamples) {
    plan_.emplace(atlas);
  }
}

void BatchFit::Fit(std::span<const Rgb> linear, std::span<Cell> cells) const {
  const auto samples =
      static_cast<std::size_t>(atlas_.width() * atlas_.height());
  RTB_CHECK_EQ(linear.size(), samples * cells.size());
  std::size_t done = 0;
  if (plan_) {
    BatchDecider decider(atlas_, *plan_, cells);
    done = SurveyCells(*plan_, linear, cells.size(), decider.batch(),
                       BatchDecider::Decide, &decider);
  }
  for (; done < cells.size(); ++done) {
    cells[done] = FitLinear(atlas_, linear.subspan(done * samples, samples));
  }
}

}  // namespace rtb
