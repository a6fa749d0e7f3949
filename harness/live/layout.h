/// @file
/// Where on the screen the picture and the panel are.
#pragma once

#include "harness/live/text.h"

namespace rtb {

/// The screen, divided.
struct Layout {
  CellRect picture;  ///< At least 1 x 1.
  CellRect panel;    ///< At the right; no columns: none.
  CellRect status;   ///< One line below the picture; no rows: none.
};

/// Divides a terminal. A wide one has the panel beside the picture, one that
/// is not wide enough a line below it, a tiny one the picture alone.
/// @param terminal at least 1 x 1.
Layout MakeLayout(GridSize terminal, bool panel);

}  // namespace rtb
