#include "harness/live/governor.h"

#include <algorithm>
#include <cmath>

namespace rtb {
namespace {

// A frame is to take this share of its interval: the rest is for drawing,
// and for what varies.
constexpr double kFill = 0.8;
// Within this of the aim nothing changes.
constexpr double kTolerance = 0.12;
constexpr int kMaxRowStep = 8;
constexpr double kRaysPerCell = 0.25;  // The least.

}  // namespace

void Governor::Describe(int spp, double samples) {
  samples = std::max(samples, 1.0);
  if (spp == spp_ && samples == samples_) return;
  // As many rays as before, if they are wanted.
  const double rays = effort_ * spp_ * samples_;
  const bool all = effort_ >= 1;
  spp_ = spp;
  samples_ = samples;
  effort_ = all ? 1 : std::clamp(rays / (spp * samples), LeastEffort(), 1.0);
  Settle();
}

void Governor::Settle() {
  mean_ms_ = 0;
  mean_encode_ms_ = 0;
  frames_ = 0;
}

double Governor::LeastEffort() const {
  return std::min(1.0, kRaysPerCell / (spp_ * samples_));
}

void Governor::Note(double render_ms, double encode_ms) {
  const double all_ms = render_ms + encode_ms;
  if (target_fps_ <= 0 || !(all_ms > 0)) return;
  constexpr double kWeight = 0.3;
  const double weight = frames_ == 0 ? 1 : kWeight;
  ++frames_;
  mean_ms_ += weight * (all_ms - mean_ms_);
  mean_encode_ms_ += weight * (encode_ms - mean_encode_ms_);
  if (frames_ < 3) return;  // One frame may be an accident.
  const double ratio = 1e3 * kFill / target_fps_ / mean_ms_;
  if (ratio < 1 - kTolerance) Slow(ratio);
  if (ratio > 1 + kTolerance) Quicken(ratio);
}

void Governor::Slow(double ratio) {
  const bool encoding = mean_encode_ms_ > mean_ms_ / 2;
  const bool at_least = effort_ <= LeastEffort();
  if (row_step_ < kMaxRowStep && (encoding || at_least)) {
    row_step_ *= 2;
  } else if (!at_least) {
    effort_ = std::max(effort_ * std::max(ratio, 0.4), LeastEffort());
  } else {
    return;
  }
  Settle();
}

void Governor::Quicken(double ratio) {
  if (row_step_ > 1) {
    if (ratio < 2.2) return;  // Twice the rows are twice the work.
    row_step_ /= 2;
  } else if (effort_ < 1) {
    if (frames_ < 8) return;  // Slowly, or the rate swings.
    effort_ = std::min(effort_ * std::min(ratio, 1.25), 1.0);
  } else {
    return;
  }
  Settle();
}

RayBudget Governor::budget() const {
  RayBudget budget;
  if (target_fps_ <= 0) {
    budget.spp = spp_;
    return budget;
  }
  const double rays = effort_ * spp_;  // Per sample.
  budget.spp = std::max(1, static_cast<int>(std::floor(rays + 1e-9)));
  budget.share = std::min(rays, 1.0);
  budget.row_step = row_step_;
  return budget;
}

}  // namespace rtb
