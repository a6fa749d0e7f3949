/// @file
/// QualityMeter: how far the shown picture is from a converged one, which is
/// computed in the background.
#pragma once

#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>

#include "encoders/cell_grid.h"
#include "harness/live/live_view.h"
#include "harness/live/panel.h"

namespace rtb {

/// A thread of low priority with a renderer of its own. The converged picture
/// grows by kStepRays rays a pixel (8 x 16 pixels a cell) up to kMostRays; the
/// figures are those of the records: FLIP at 40 pixels per degree, and the
/// mean squared error of encoded values, against the raster that geometric
/// masks decode.
class QualityMeter {
 public:
  static constexpr int kStepRays = 4;
  static constexpr int kMostRays = 64;

  QualityMeter();
  ~QualityMeter();
  QualityMeter(const QualityMeter&) = delete;
  QualityMeter& operator=(const QualityMeter&) = delete;

  /// The picture that is shown of this view; takes the place of one that has
  /// not been judged.
  void Show(const LiveView& view, const CellGrid& picture);
  /// What was shown does not count any more.
  void Forget();

  /// The figures of the last picture that was judged since Forget().
  std::optional<LiveQuality> latest() const;

 private:
  struct Shown {
    LiveView view;
    CellGrid picture;
  };

  void Run();

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::optional<Shown> shown_;
  std::optional<LiveQuality> latest_;
  bool news_ = false;
  bool stop_ = false;
  std::thread thread_;
};

}  // namespace rtb
