#include "encoders/adaptive/slot_kernels.h"

#include <algorithm>
#include <cmath>

// This file is compiled once for each target.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "encoders/adaptive/slot_kernels.cc"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "encoders/adaptive/slot_vectors-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rtb {
namespace HWY_NAMESPACE {

/// A sample and the slots that it may be nearest to.
struct EnteredSample {
  const SeenSample& sample;
  V2f at;            ///< In slots.
  int x, y;          ///< Its slot.
  int across, down;  ///< So many slots further.
};

/// The squared distance of slots from a sample along one axis, beyond what it
/// may be nearest to kFar2.
/// @param index of slots in their cell, `first` being that of the cell.
HWY_INLINE F AwayFrom(const float* index, int first, float at, int slot,
                      int most, float pitch) {
  const F slots = hn::Add(Load(index), Same(static_cast<float>(first)));
  const F away = hn::Mul(hn::Add(slots, Same(0.5f - at)), Same(pitch));
  const F steps = hn::Abs(hn::Sub(slots, Same(static_cast<float>(slot))));
  return hn::IfThenElse(hn::Le(steps, Same(static_cast<float>(most))),
                        hn::Mul(away, away), Same(kFar2));
}

/// Of the slots of a row of cells the squared distances along y.
struct RowDistances {
  F of[kVectors];
};

/// One cell against one sample.
HWY_INLINE void EnterCell(const EnteredSample& entered, const RowDistances& dy2,
                          int column, int row, const SlotGrid& slots) {
  const SlotFloats d;
  const auto cell = slots.At(column, row);
  const Rgb& color = entered.sample.encoded;
  std::uint32_t changed = 0;
  F dx2 = Same(0.0f);
  for (int v = 0; v < kVectors; ++v) {
    const int i = v * kLanes;
    if (NewColumns(i)) {
      dx2 = AwayFrom(kPlaces.column + i, column * kSlotColumns, entered.at.x,
                     entered.x, entered.across, slots.pitch.x);
    }
    const auto at = cell * kSlots + i;
    const F now = hn::Add(dx2, dy2.of[v]);
    const F before = Load(slots.distance2 + at);
    const auto nearer = hn::Lt(now, before);
    if (hn::AllFalse(d, nearer)) continue;
    // Whole, since it is soon read again.
    Store(hn::IfThenElse(nearer, now, before), slots.distance2 + at);
    hn::BlendedStore(Same(color.x), nearer, d, slots.r + at);
    hn::BlendedStore(Same(color.y), nearer, d, slots.g + at);
    hn::BlendedStore(Same(color.z), nearer, d, slots.b + at);
    changed |= BitsOf(nearer) << i;
  }
  slots.changed[cell] |= changed;
}

HWY_INLINE void EnterSample(const EnteredSample& entered, int first, int last,
                            const SlotGrid& slots) {
  const int columns = slots.grid.columns;
  const int left = std::max(0, entered.x - entered.across) / kSlotColumns;
  const int right =
      std::min(columns * kSlotColumns - 1, entered.x + entered.across) /
      kSlotColumns;
  const int top = std::max(first * kSlotRows, entered.y - entered.down);
  const int bottom =
      std::min((last + 1) * kSlotRows - 1, entered.y + entered.down);
  if (top > bottom) return;
  for (int row = top / kSlotRows; row <= bottom / kSlotRows; ++row) {
    RowDistances dy2;
    for (int v = 0; v < kVectors; ++v) {
      dy2.of[v] =
          AwayFrom(kPlaces.row + v * kLanes, row * kSlotRows, entered.at.y,
                   entered.y, entered.down, slots.pitch.y);
    }
    for (int column = left; column <= right; ++column) {
      EnterCell(entered, dy2, column, row, slots);
    }
  }
}

void EnterAll(std::span<const SeenSample> samples,
              std::span<const float> reaches, int first, int last,
              const SlotGrid& slots) {
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const SeenSample& sample = samples[i];
    const int column = sample.cell % slots.grid.columns;
    const int row = sample.cell / slots.grid.columns;
    const V2f at = (V2f(static_cast<float>(column), static_cast<float>(row)) +
                    sample.position) *
                   V2f(kSlotColumns, kSlotRows);
    const EnteredSample entered = {
        sample,
        at,
        static_cast<int>(at.x),
        static_cast<int>(at.y),
        static_cast<int>(std::ceil(reaches[i] / slots.pitch.x)),
        static_cast<int>(std::ceil(reaches[i] / slots.pitch.y))};
    EnterSample(entered, first, last, slots);
    if (row < first || row > last) continue;
    const int slot = (entered.y - row * kSlotRows) * kSlotColumns +
                     (entered.x - column * kSlotColumns);
    const auto cell = slots.At(column, row);
    slots.changed[cell] |= std::uint32_t{1} << slot;
    float& extent = slots.extent[cell * kSlots + slot];
    // The usual one needs no division.
    extent =
        extent == kEmptySlot ? WithOneMore(kEmptySlot) : WithOneMore(extent);
  }
}

/// A channel's squared difference between the slots on two sides.
struct Across {
  F beside, above;
};

/// @param i the first of the slots of the cell that `channel` points to.
HWY_INLINE Across AcrossOf(const float* channel, int i, std::ptrdiff_t row) {
  const F beside = hn::Sub(LeftOf(channel, i), RightOf(channel, i));
  const F above = hn::Sub(AboveOf(channel, i, row), BelowOf(channel, i, row));
  return {hn::Mul(beside, beside), hn::Mul(above, above)};
}

/// @return the best gain of the cell.
HWY_INLINE float CompareCell(const SlotGrid& slots, std::ptrdiff_t cell,
                             float least, bool root) {
  const SlotFloats d;
  const auto from = cell * kSlots;
  const auto row = slots.stride() * kSlots;
  F best = Same(0.0f);
  for (int i = 0; i < kSlots; i += kLanes) {
    const Across r = AcrossOf(slots.r + from, i, row);
    const Across g = AcrossOf(slots.g + from, i, row);
    const Across b = AcrossOf(slots.b + from, i, row);
    F contrast = hn::Max(hn::Add(hn::Add(r.beside, g.beside), b.beside),
                         hn::Add(hn::Add(r.above, g.above), b.above));
    contrast = hn::Add(contrast, Same(least));
    if (root) contrast = hn::Sqrt(contrast);
    Store(contrast, slots.contrast + from + i);
    best = hn::Max(best, GainOf(contrast, Load(slots.distance2 + from + i),
                                Load(slots.extent + from + i)));
  }
  return hn::GetLane(hn::MaxOfLanes(d, best));
}

void CompareRow(const SlotGrid& slots, int row, float least, bool root,
                float* best) {
  const std::ptrdiff_t stride = slots.stride();
  for (int column = 0; column < slots.grid.columns; ++column) {
    const auto cell = slots.At(column, row);
    const std::uint32_t* const changed = slots.changed + cell;
    // Of the cells around, what lies beside this one counts.
    const std::uint32_t new_colors =
        *changed | (changed[-1] & kLastColumn) | (changed[1] & kFirstColumn) |
        (changed[-stride] & kLastRow) | (changed[stride] & kFirstRow);
    if (new_colors != 0) best[column] = CompareCell(slots, cell, least, root);
  }
}

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace rtb
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rtb {

HWY_EXPORT(EnterAll);
HWY_EXPORT(CompareRow);

void EnterSamples(std::span<const SeenSample> samples,
                  std::span<const float> reaches, int first, int last,
                  const SlotGrid& slots) {
  HWY_DYNAMIC_DISPATCH(EnterAll)(samples, reaches, first, last, slots);
}

void CompareSlots(const SlotGrid& slots, int row, float least, bool root,
                  float* best) {
  HWY_DYNAMIC_DISPATCH(CompareRow)(slots, row, least, root, best);
}

}  // namespace rtb
#endif  // HWY_ONCE
