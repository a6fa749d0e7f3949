/// @file
/// ScreenDiff: which cells to send, by how different they would look.
#pragma once

#include <limits>
#include <vector>

#include "encoders/cell_grid.h"
#include "harness/live/appearance.h"

namespace rtb {

/// How much difference may stay on the screen for the time being.
struct DiffLimits {
  /// RMS over a cell's look in 8-bit values; what is less may wait. 0: send
  /// whatever looks different.
  float threshold = 0;
  /// Frames after which a cell that differs is sent, however little.
  int oldest = 30;
  /// Cells a frame; the largest differences come first.
  int budget = std::numeric_limits<int>::max();
};

/// Knows what a terminal shows.
class ScreenDiff {
 public:
  /// Chooses the cells of `wanted` to send, by rising index, and takes them
  /// for sent. A new size makes everything unknown.
  std::vector<int> Select(const CellGrid& wanted, const DiffLimits& limits);

  /// Nothing is known of the screen any more: the next frame sends it all.
  void Invalidate() { known_ = false; }

  /// Whether the screen was unknown until the last Select: clear it first.
  bool cleared() const { return cleared_; }

  /// Whether the screen looks as was last wanted, everywhere.
  bool exact() const { return waiting_ == 0; }

  /// Cells whose glyph or colors differ from those that were wanted before:
  /// what a comparison of cells would have sent.
  int differing() const { return differing_; }

  /// What the screen shows.
  const CellGrid& shown() const { return shown_; }

 private:
  struct Candidate {
    float priority;
    int index;
  };

  std::vector<int> SendAll(const CellGrid& wanted);
  std::vector<Candidate> Candidates(const CellGrid& wanted,
                                    const DiffLimits& limits);

  AppearanceTable table_;
  CellGrid shown_;
  CellGrid wanted_;        ///< Last.
  std::vector<int> ages_;  ///< Frames for which a cell has differed.
  bool known_ = false;
  bool cleared_ = false;
  int waiting_ = 0;
  int differing_ = 0;
};

}  // namespace rtb
