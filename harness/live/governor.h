/// @file
/// Governor: drops rays before frames.
#pragma once

#include "harness/live/live_view.h"

namespace rtb {

/// Watches what frames take and says how many rays the next one may have.
/// First the rays per sample go, then the share of the samples that is traced
/// (down to one ray for four cells). Rows take turns when that is not enough,
/// or when it is encoding that takes most of the time.
class Governor {
 public:
  /// @param target_fps 0: every frame gets all its rays.
  explicit Governor(double target_fps) : target_fps_(target_fps) {}

  void set_target_fps(double fps) { target_fps_ = fps; }
  double target_fps() const { return target_fps_; }

  /// What a picture would take in full.
  /// @param samples per cell that the encoder asks for.
  void Describe(int spp, double samples);

  /// A frame of the current budget took that long, in milliseconds; loading
  /// does not count.
  void Note(double render_ms, double encode_ms);

  /// For the next frame.
  RayBudget budget() const;

 private:
  void Slow(double ratio);
  void Quicken(double ratio);
  double LeastEffort() const;
  void Settle();

  double target_fps_;
  int spp_ = 1;
  double samples_ = 1;
  double effort_ = 1;  ///< Share of all rays, in (0, 1].
  int row_step_ = 1;
  double mean_ms_ = 0;         ///< Of the last frames; 0: none yet.
  double mean_encode_ms_ = 0;  ///< The part of encoding.
  int frames_ = 0;             ///< Since the budget changed.
};

}  // namespace rtb
