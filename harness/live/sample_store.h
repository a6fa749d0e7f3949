/// @file
/// SampleStore: a FragmentSource that remembers. It traces a share of the
/// samples each frame, and their mean grows better while the view rests.
#pragma once

#include <functional>
#include <vector>

#include "core/render/fragment_source.h"

namespace rtb {

/// Stands between an encoder and a renderer. The first plan of a frame that
/// asks for all cells is answered from what has been traced in this epoch;
/// further plans (of encoders that ask in rounds) are passed on as they are.
///
/// The first ray of a sample goes through its position; later ones through
/// positions that spread over its footprint. A sample that has no ray yet
/// shows the nearest one that has.
class SampleStore : public FragmentSource {
 public:
  /// A picture at rest is good enough with so many rays in every sample; then
  /// nothing more is traced.
  static constexpr int kMostRays = 256;

  /// Renders a plan. @param pass differs between the frames of an epoch, and
  /// is to give random numbers of its own.
  using Tracer =
      std::function<Result<Fragments>(const SamplePlan& plan, int pass)>;

  /// Begins a frame.
  /// @param epoch samples of another epoch mean nothing any more.
  /// @param share of the samples to trace, in (0, 1].
  /// @param threads upper bound; 0 = all cores.
  void BeginFrame(Tracer tracer, int epoch, double share, int threads);

  Result<Fragments> Query(const SamplePlan& plan) override;

  /// Samples traced since BeginFrame.
  std::size_t traced() const { return traced_; }
  /// Of the plans that it keeps; 0: none yet.
  int samples_per_cell() const { return plan_.samples_per_cell; }
  /// Rays that every sample of the epoch has at least, as the last frame
  /// left it.
  int least_rays() const;

 private:
  void Reset(const SamplePlan& plan);
  bool Fits(const SamplePlan& plan) const;
  /// All samples, once more.
  SamplePlan WholePass() const;
  /// The samples whose turn it is: `picked_`.
  SamplePlan PartialPass();
  void Add(const Fragments& fragments, bool whole);
  Fragments Means() const;
  Rgb Mean(std::size_t sample) const;
  void FillCell(int cell, Fragments* fragments) const;
  /// A sample with a ray in or near the cell; the nearest to `wanted` if it
  /// is in the cell itself.
  std::size_t Nearest(int cell, int wanted) const;
  /// The first sample of a cell that has a ray; -1 for none.
  std::ptrdiff_t AnyOf(int column, int row) const;
  /// Whose turn a sample is: 0 .. turns() - 1.
  int TurnOf(int cell, int sample) const;
  int turns() const { return 4 * plan_.samples_per_cell; }
  V2f JitteredPosition(int entry, int sample, int rays) const;

  Tracer tracer_;
  int epoch_ = -1;
  double share_ = 1;
  int threads_ = 0;
  bool asked_ = false;  ///< The frame's first plan has been answered.
  std::size_t traced_ = 0;

  SamplePlan plan_;
  int kept_epoch_ = -1;
  int pass_ = 0;
  int turn_ = 0;            ///< The first turn of the next frame.
  std::vector<int> order_;  ///< Position of each sample among a cell's turns.
  std::vector<Rgb> sums_;
  std::vector<float> variances_;  ///< Summed; empty where unknown.
  std::vector<int> rays_;
  std::vector<std::size_t> picked_;
};

}  // namespace rtb
