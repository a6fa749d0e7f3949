/// @file
/// Times encoders on samples that lie in memory.
#pragma once

#include <memory>
#include <vector>

#include "core/base/result.h"
#include "core/render/fragment_source.h"
#include "encoders/encoder.h"

namespace rtb {

/// The canonical grid.
inline constexpr GridSize kBenchGrid{120, 40};

/// Seconds of the calling thread's processor time.
double ThreadSeconds();

/// Times that were measured, in seconds.
class Samples {
 public:
  void Add(double seconds) { seconds_.push_back(seconds); }
  double Median() const;
  double Least() const;

 private:
  std::vector<double> seconds_;
};

/// Renders the Cornell box, and says the same again when it is asked the same
/// questions again; times itself.
class RecordedSource : public FragmentSource {
 public:
  /// @return the errors of loading the scene.
  static Result<std::unique_ptr<RecordedSource>> Make();

  Result<Fragments> Query(const SamplePlan& plan) override;

  /// Begins the questions anew.
  void Rewind();

  /// Since Rewind().
  double spent_seconds() const { return spent_; }

 private:
  RecordedSource() = default;
  Result<Fragments> Answer(const SamplePlan& plan);

  struct Recording;
  std::shared_ptr<Recording> recording_;
  std::size_t next_ = 0;
  double spent_ = 0;
};

/// Runs one encoder again and again, on one thread.
class EncodeTimer {
 public:
  static Result<std::unique_ptr<EncodeTimer>> Make(const Encoder& encoder);

  /// The encoder's own time, without that of its source.
  Result<double> Run(bool scalar);

 private:
  EncodeTimer(const Encoder& encoder, std::unique_ptr<RecordedSource> source)
      : encoder_(encoder), source_(std::move(source)) {}

  const Encoder& encoder_;
  std::unique_ptr<RecordedSource> source_;
};

}  // namespace rtb
