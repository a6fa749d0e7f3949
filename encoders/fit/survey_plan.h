/// @file
/// SurveyPlan: how vector code computes every candidate's correlation with the
/// samples of many cells at once. Atlas -> SurveyPlan -> SurveyCells.
#pragma once

#include <cstdint>
#include <vector>

#include "encoders/fit/atlas.h"

namespace rtb {

/// Sums over the samples of a cell that many masks share: of each row's left
/// half and right half (2 y, 2 y + 1), then of each column.
struct SurveyBands {
  int width = 0;
  int height = 0;

  int count() const { return 2 * height + width; }
  int column(int x) const { return 2 * height + x; }
  /// Where the right half of a row begins.
  int middle() const { return width / 2; }
};

/// How a candidate's correlation comes about.
enum class SurveyWay {
  kDifference,  ///< Another candidate's, and whole bands more or less: exact.
  kBands,       ///< Weighted bands.
  kPixels,      ///< Weighted samples.
};

/// One term of a correlation. A band or a sub-pixel, and how much of it.
struct SurveyTerm {
  int index;
  float weight;
};

/// One candidate, in terms of the least squares (docs/optimal.md).
struct SurveyCandidate {
  int index;  ///< In the atlas.
  SurveyWay way;
  int parent;  ///< Position in the plan of the other candidate; -1: nothing.
  std::size_t first_term, end_term;
  bool binary;
  float share;             ///< M / n
  float inverse_variance;  ///< 1 / V; 0 for a constant mask.
  float aa, twice_ab, bb;  ///< Sums of m^2, 2 m (1 - m), (1 - m)^2.
  float covered, free;     ///< Sub-pixels of coverage 1, and of 0.
  float slack;  ///< Bound of the error's error, in shares of the squares' sum.
};

/// Immutable; safe to share between threads.
struct SurveyPlan {
  /// Up to this many samples the sums fit 32 bits, and the tables the cache.
  static constexpr int kMaxSamples = 128;

  explicit SurveyPlan(const Atlas& atlas);

  SurveyBands bands;
  std::vector<SurveyCandidate> candidates;  ///< Without complements.
  std::vector<SurveyTerm> terms;
  bool has_pixels = false;  ///< Whether any candidate has the way kPixels.
  /// A cell of one color no farther than this from a code, in codes, is best
  /// shown by any glyph in that code.
  double flat_limit = 0.5;
};

}  // namespace rtb
