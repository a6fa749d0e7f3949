#include "encoders/adaptive/lattice.h"

#include <algorithm>

namespace rtb {
namespace {

LatticeSample SampleAt(const V2f& position, int column, int row,
                       float cell_width) {
  LatticeSample sample;
  sample.column = column;
  sample.row = row;
  const V2f from =
      position + V2f(static_cast<float>(column), static_cast<float>(row));
  for (int slot = 0; slot < kSlots; ++slot) {
    const V2f away = (SlotCenter(slot) - from) * V2f(cell_width, kCellHeight);
    sample.distance2[static_cast<std::size_t>(slot)] =
        away.x * away.x + away.y * away.y;
  }
  return sample;
}

}  // namespace

Lattice::Lattice(std::span<const V2f> positions, float cell_width)
    : per_cell(positions.size()) {
  for (int row = -1; row <= 1; ++row) {
    for (int column = -1; column <= 1; ++column) {
      for (std::size_t i = 0; i < positions.size(); ++i) {
        around.push_back(SampleAt(positions[i], column, row, cell_width));
        around.back().number = i;
      }
    }
  }
  for (const V2f& position : positions) ++samples[SlotAt(position)];
  std::vector<bool> wanted(around.size());
  for (std::size_t slot = 0; slot < kSlots; ++slot) {
    const auto first = std::ranges::min_element(
        around, {},
        [slot](const LatticeSample& sample) { return sample.distance2[slot]; });
    wanted[static_cast<std::size_t>(first - around.begin())] = true;
  }
  for (std::size_t i = 0; i < around.size(); ++i) {
    if (wanted[i]) nearest.push_back(around[i]);
  }
}

}  // namespace rtb
