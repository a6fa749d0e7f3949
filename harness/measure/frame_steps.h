/// @file
/// What changes from frame to frame of a sequence, beside its reference.
#pragma once

#include "core/image/image.h"
#include "encoders/cell_grid.h"

namespace rtb {

/// One moment of a sequence; images are sRGB-encoded values of one size.
struct Frame {
  CellGrid grid;
  Image drawn;      ///< The grid, decoded.
  Image reference;  ///< What it should look like.
};

/// Share of cells whose glyph or colors differ, in canonical form.
double ChangedCells(const CellGrid& a, const CellGrid& b);

/// Root of the mean over pixels and channels of the squared difference.
double RmsDifference(const Image& a, const Image& b, int threads);

/// Mean over pixels and channels of |(T_t - T_t-1) - (R_t - R_t-1)|: the
/// change that the drawn frames add to or take from the reference's.
double TemporalDifferenceError(const Frame& now, const Frame& before,
                               int threads);

/// Mean over pixels of |FLIP(T_t-1, T_t) - FLIP(R_t-1, R_t)|, map by map, at
/// kFlipPpd.
double TemporalFlip(const Frame& now, const Frame& before, int threads);

}  // namespace rtb
