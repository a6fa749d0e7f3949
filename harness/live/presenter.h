/// @file
/// Presenter: from a grid of cells to the bytes that show it on a terminal.
/// The flow: picture + panel + help -> one CellGrid -> ScreenDiff ->
/// Presenter -> OutputQueue.
#pragma once

#include <memory>
#include <span>
#include <string>

#include "core/base/result.h"
#include "encoders/cell_grid.h"
#include "encoders/color_depth.h"

namespace rtb {

/// One frame.
struct ScreenUpdate {
  const CellGrid& screen;
  std::span<const int> changed;  ///< Indices of cells, rising.
  bool clear = false;            ///< The terminal's content is unknown.
};

/// Draws on one terminal.
class Presenter {
 public:
  virtual ~Presenter() = default;

  /// The name by which records know it.
  virtual const char* name() const = 0;

  /// The bytes of a frame.
  virtual Result<std::string> Draw(const ScreenUpdate& update) = 0;
};

/// Writes escape sequences itself (AnsiFrame).
std::unique_ptr<Presenter> MakeDirectPresenter(ColorDepth depth);

/// Draws through ncurses, with color pairs of its own pool. LC_CTYPE must be a
/// UTF-8 one. One at a time.
/// @param term the terminal's name; with kTruecolor an entry with 24-bit
///   colors takes its place.
/// @return kBadInput for an unknown terminal, kMissing where terminfo has no
///   entry with 24-bit colors.
Result<std::unique_ptr<Presenter>> MakeNcursesPresenter(const std::string& term,
                                                        ColorDepth depth,
                                                        GridSize size);

}  // namespace rtb
