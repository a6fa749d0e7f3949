/// @file
/// The inner loops over slots, by vectors: VoronoiMap's and SlotGains'. Highway
/// chooses the instruction set at run time; all give the same bits.
#pragma once

#include <array>
#include <cstddef>

#include "core/math/vec.h"
#include "encoders/adaptive/slots.h"

namespace rtb {

/// Lanes of any instruction set: so many floats after what a row of slots holds
/// may be read and written back.
inline constexpr std::size_t kSlotRoom = 16;

/// The gains of all slots of a cell.
using CellGains = std::array<float, kSlots>;

/// Fills in the gains of a cell's slots.
/// @return the slot of the largest, of equal ones the first.
int FindGains(const CellSlots& slots, CellGains& gains);

/// Counts on one more sample in a cell: distances and gains anew.
/// @return as FindGains.
int ExpectSample(const V2f& position, float cell_width, CellSlots& slots,
                 CellGains& gains);

/// Rows of slots side by side, as arrays of `stride` floats a row.
struct SlotRows {
  std::size_t stride = 0;
  int columns = 0;  ///< Of slots, from where the pointers point.
  int rows = 0;
  float* distance2 = nullptr;
  float* r = nullptr;
  float* g = nullptr;
  float* b = nullptr;
};

/// A sample to enter into slots.
struct EnteredSample {
  V2f at{0, 0};     ///< In slots.
  V2f pitch{0, 0};  ///< From slot to slot.
  Rgb color{0};
  int left = 0, top = 0;  ///< Which slot SlotRows begins with.
};

/// Gives the slots that the sample is nearer to than what they have its
/// distance and color.
void EnterSample(const EnteredSample& sample, const SlotRows& slots);

/// What CompareSlots finds.
struct ComparedRows {
  const float* extent = nullptr;
  float* contrast = nullptr;
  float* best = nullptr;  ///< Of each column, the largest gain in its rows.
};

/// The contrasts of slots, with a row and a column of others on every side, and
/// their gains.
/// @param least added to every squared contrast.
/// @param root whether its root counts.
void CompareSlots(const SlotRows& slots, float least, bool root,
                  const ComparedRows& out);

}  // namespace rtb
