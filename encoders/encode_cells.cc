#include "encoders/encode_cells.h"

#include "core/base/check.h"
#include "core/base/parallel.h"

namespace rtb {
namespace {

/// Cells per task, a multiple of any number of lanes: 1 to 10 microseconds of
/// work, whatever the grid.
constexpr int kGrain = 64;

}  // namespace

CellGrid EncodeCells(const Fragments& fragments, int samples, int threads,
                     const CellEncoder& encode) {
  const auto count = static_cast<std::size_t>(samples);
  return EncodeCells(fragments, samples, threads,
                     [&](std::span<const Rgb> linear, std::span<Cell> cells) {
                       for (std::size_t i = 0; i < cells.size(); ++i) {
                         cells[i] = encode(linear.subspan(i * count, count));
                       }
                     });
}

CellGrid EncodeCells(const Fragments& fragments, int samples, int threads,
                     const CellsEncoder& encode) {
  RTB_CHECK_EQ(fragments.samples_per_cell, samples);
  CellGrid grid(fragments.grid);
  const std::span all(fragments.values);
  ParallelFor(fragments.grid.cells(), kGrain, threads, [&](int begin, int end) {
    const auto first = static_cast<std::size_t>(begin);
    const auto cells = static_cast<std::size_t>(end - begin);
    const auto count = static_cast<std::size_t>(samples);
    encode(all.subspan(first * count, cells * count),
           std::span(grid.cells).subspan(first, cells));
  });
  return grid;
}

}  // namespace rtb
