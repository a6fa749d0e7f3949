/// @file
/// Region: a part of a picture that is encoded by itself - one side of a
/// split screen, or every n-th row.
#pragma once

#include "core/render/fragment_source.h"

namespace rtb {

/// `columns` columns from first_column on, of the rows first_row, first_row +
/// row_step, ... of a grid.
struct Region {
  GridSize grid;  ///< The whole picture.
  int first_column = 0;
  int columns = 0;
  int first_row = 0;
  int row_step = 1;

  /// The region as a grid of its own.
  GridSize size() const {
    return {columns, (grid.rows - first_row + row_step - 1) / row_step};
  }
  /// The picture's cell that is number `cell` of the region.
  int CellOf(int cell) const {
    const int row = first_row + cell / columns * row_step;
    return row * grid.columns + first_column + cell % columns;
  }
  bool whole() const { return columns == grid.columns && row_step == 1; }
  bool operator==(const Region&) const = default;
};

/// Answers plans of the region's grid from a source of the whole picture.
class RegionSource : public FragmentSource {
 public:
  /// The source must outlive this.
  RegionSource(FragmentSource& picture, const Region& region)
      : picture_(picture), region_(region) {}

  Result<Fragments> Query(const SamplePlan& plan) override;

 private:
  FragmentSource& picture_;
  Region region_;
};

}  // namespace rtb
