#include "harness/live/quality_meter.h"

#include <sys/resource.h>
#include <unistd.h>

#include <utility>

#include "encoders/decode.h"
#include "harness/live/progressive_image.h"
#include "harness/live/signals.h"
#include "harness/metrics/metric.h"

namespace rtb {
namespace {

double Figure(const char* metric, const MetricInput& input) {
  return FindMetric(metric)->compute(input).value_or(0);
}

/// Judges a picture, after the converged one has grown by a step.
Result<LiveQuality> Judge(const LiveView& view, const CellGrid& picture,
                          ProgressiveImage* converged) {
  RTB_RETURN_IF_ERROR(converged->Aim(view));
  if (converged->rays() < QualityMeter::kMostRays) {
    RTB_RETURN_IF_ERROR(converged->Step(QualityMeter::kStepRays));
  }
  const Image reference = converged->Displayed();
  DecodeOptions options;
  options.cell_width = ProgressiveImage::kCellWidth;
  options.cell_height = ProgressiveImage::kCellHeight;
  options.threads = 1;
  RTB_ASSIGN_OR_RETURN(const Image shown, Decode(picture, options));
  const MetricInput input(reference, shown, 1);
  return LiveQuality{Figure("flip", input), Figure("mse", input),
                     converged->rays()};
}

}  // namespace

QualityMeter::QualityMeter() {
  const SignalsBlocked blocked;
  thread_ = std::thread([this] { Run(); });
}

QualityMeter::~QualityMeter() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void QualityMeter::Show(const LiveView& view, const CellGrid& picture) {
  {
    const std::lock_guard lock(mutex_);
    if (shown_ && !SamePicture(shown_->view, view)) latest_.reset();
    shown_ = {view, picture};
    news_ = true;
  }
  changed_.notify_all();
}

void QualityMeter::Forget() {
  const std::lock_guard lock(mutex_);
  shown_.reset();
  latest_.reset();
}

std::optional<LiveQuality> QualityMeter::latest() const {
  const std::lock_guard lock(mutex_);
  return latest_;
}

void QualityMeter::Run() {
  constexpr int kLowest = 19;
  // Of this thread alone, on Linux.
  ::setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()), kLowest);
  ProgressiveImage converged;
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return stop_ || (shown_ && news_); });
    if (stop_) return;
    const Shown shown = *shown_;
    news_ = false;
    lock.unlock();
    const auto quality = Judge(shown.view, shown.picture, &converged);
    lock.lock();
    if (!shown_ || !SamePicture(shown_->view, shown.view)) continue;
    if (quality) latest_ = *quality;
    // Goes on by itself until the picture has converged.
    if (quality && quality->passes < kMostRays) news_ = true;
  }
}

}  // namespace rtb
