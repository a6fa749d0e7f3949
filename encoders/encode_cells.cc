#include "encoders/encode_cells.h"

#include "core/base/check.h"
#include "core/base/parallel.h"

namespace rtb {
namespace {

/// Cells per task: some 10 microseconds of work, whatever the grid.
constexpr int kGrain = 64;

}  // namespace

CellGrid EncodeCells(const Fragments& fragments, int samples, int threads,
                     const CellEncoder& encode) {
  RTB_CHECK_EQ(fragments.samples_per_cell, samples);
  CellGrid grid(fragments.grid);
  ParallelFor(fragments.grid.cells(), kGrain, threads, [&](int begin, int end) {
    for (int cell = begin; cell < end; ++cell) {
      grid.cells[static_cast<std::size_t>(cell)] = encode(fragments.cell(cell));
    }
  });
  return grid;
}

}  // namespace rtb
