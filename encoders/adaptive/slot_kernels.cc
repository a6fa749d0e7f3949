#include "encoders/adaptive/slot_kernels.h"

#include <algorithm>

// This file is compiled once for each target.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "encoders/adaptive/slot_kernels.cc"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace rtb {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using SlotFloats = hn::CappedTag<float, kSlotRoom>;
using F = hn::Vec<SlotFloats>;

HWY_INLINE F Same(float v) { return hn::Set(SlotFloats(), v); }
HWY_INLINE F Load(const float* from) { return hn::LoadU(SlotFloats(), from); }
HWY_INLINE void Store(F v, float* to) { hn::StoreU(v, SlotFloats(), to); }

/// The function of that name in slots.h.
HWY_INLINE F GainOf(F contrast, F distance2, F extent) {
  const F area = hn::Add(distance2, extent);
  return hn::Mul(hn::Mul(hn::Mul(contrast, area), area), hn::Sqrt(area));
}

int FirstLargest(const CellGains& gains) {
  const SlotFloats d;
  F most = Load(gains.data());
  for (std::size_t i = hn::Lanes(d); i < gains.size(); i += hn::Lanes(d)) {
    most = hn::Max(most, Load(&gains[i]));
  }
  most = hn::MaxOfLanes(d, most);
  for (std::size_t i = 0; i < gains.size(); i += hn::Lanes(d)) {
    const auto at = hn::FindFirstTrue(d, hn::Eq(Load(&gains[i]), most));
    if (at >= 0) return static_cast<int>(i) + static_cast<int>(at);
  }
  return 0;
}

int FindSlotGains(const CellSlots& slots, CellGains& gains) {
  for (std::size_t i = 0; i < gains.size(); i += hn::Lanes(SlotFloats())) {
    Store(GainOf(Load(&slots.contrast[i]), Load(&slots.distance2[i]),
                 Load(&slots.extent[i])),
          &gains[i]);
  }
  return FirstLargest(gains);
}

/// The centers of the slots of a cell.
struct SlotCenters {
  std::array<float, kSlots> x;
  std::array<float, kSlots> y;

  SlotCenters() {
    for (int slot = 0; slot < kSlots; ++slot) {
      x[static_cast<std::size_t>(slot)] = SlotCenter(slot).x;
      y[static_cast<std::size_t>(slot)] = SlotCenter(slot).y;
    }
  }
};

int ExpectInSlots(const V2f& position, float cell_width, CellSlots& slots,
                  CellGains& gains) {
  static const SlotCenters centers;
  for (std::size_t i = 0; i < gains.size(); i += hn::Lanes(SlotFloats())) {
    const F dx = hn::Mul(hn::Sub(Load(&centers.x[i]), Same(position.x)),
                         Same(cell_width));
    const F dy = hn::Mul(hn::Sub(Load(&centers.y[i]), Same(position.y)),
                         Same(kCellHeight));
    const F distance2 = hn::Min(Load(&slots.distance2[i]),
                                hn::Add(hn::Mul(dx, dx), hn::Mul(dy, dy)));
    Store(distance2, &slots.distance2[i]);
    Store(GainOf(Load(&slots.contrast[i]), distance2, Load(&slots.extent[i])),
          &gains[i]);
  }
  return FirstLargest(gains);
}

/// One row of slots against one sample.
HWY_INLINE void EnterRow(const EnteredSample& sample, F dy2, int columns,
                         float* distance2, float* r, float* g, float* b) {
  const SlotFloats d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const F first = Same(static_cast<float>(sample.left) + 0.5f - sample.at.x);
  for (int i = 0; i < columns; i += lanes) {
    const F place = hn::Iota(d, static_cast<float>(i));
    const F dx = hn::Mul(hn::Add(first, place), Same(sample.pitch.x));
    const F now = hn::Add(hn::Mul(dx, dx), dy2);
    const F before = Load(distance2 + i);
    const auto inside = hn::FirstN(d, static_cast<std::size_t>(columns - i));
    const auto nearer = hn::And(inside, hn::Lt(now, before));
    Store(hn::IfThenElse(nearer, now, before), distance2 + i);
    Store(hn::IfThenElse(nearer, Same(sample.color.x), Load(r + i)), r + i);
    Store(hn::IfThenElse(nearer, Same(sample.color.y), Load(g + i)), g + i);
    Store(hn::IfThenElse(nearer, Same(sample.color.z), Load(b + i)), b + i);
  }
}

void EnterIntoSlots(const EnteredSample& sample, const SlotRows& slots) {
  for (int row = 0; row < slots.rows; ++row) {
    const float dy =
        (static_cast<float>(sample.top + row) + 0.5f - sample.at.y) *
        sample.pitch.y;
    const std::size_t at = static_cast<std::size_t>(row) * slots.stride;
    EnterRow(sample, Same(dy * dy), slots.columns, slots.distance2 + at,
             slots.r + at, slots.g + at, slots.b + at);
  }
}

/// Squared distances between colors one place apart on two sides.
HWY_INLINE F Apart(const float* at_r, const float* at_g, const float* at_b,
                   std::ptrdiff_t side) {
  const F dr = hn::Sub(Load(at_r - side), Load(at_r + side));
  const F dg = hn::Sub(Load(at_g - side), Load(at_g + side));
  const F db = hn::Sub(Load(at_b - side), Load(at_b + side));
  return hn::Add(hn::Add(hn::Mul(dr, dr), hn::Mul(dg, dg)), hn::Mul(db, db));
}

void CompareSlotRows(const SlotRows& slots, float least, bool root,
                     const ComparedRows& out) {
  const auto lanes = static_cast<int>(hn::Lanes(SlotFloats()));
  const auto stride = static_cast<std::ptrdiff_t>(slots.stride);
  for (int i = 0; i < slots.columns; i += lanes) {
    F best = Same(0.0f);
    for (int row = 0; row < slots.rows; ++row) {
      const std::ptrdiff_t at = row * stride + i;
      const float* const r = slots.r + at;
      const float* const g = slots.g + at;
      const float* const b = slots.b + at;
      F contrast = hn::Add(hn::Max(Apart(r, g, b, 1), Apart(r, g, b, stride)),
                           Same(least));
      if (root) contrast = hn::Sqrt(contrast);
      Store(contrast, out.contrast + at);
      best = hn::Max(best, GainOf(contrast, Load(slots.distance2 + at),
                                  Load(out.extent + at)));
    }
    Store(best, out.best + i);
  }
}

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace rtb
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rtb {

HWY_EXPORT(FindSlotGains);
HWY_EXPORT(ExpectInSlots);
HWY_EXPORT(EnterIntoSlots);
HWY_EXPORT(CompareSlotRows);

int FindGains(const CellSlots& slots, CellGains& gains) {
  return HWY_DYNAMIC_DISPATCH(FindSlotGains)(slots, gains);
}

int ExpectSample(const V2f& position, float cell_width, CellSlots& slots,
                 CellGains& gains) {
  return HWY_DYNAMIC_DISPATCH(ExpectInSlots)(position, cell_width, slots,
                                             gains);
}

void EnterSample(const EnteredSample& sample, const SlotRows& slots) {
  HWY_DYNAMIC_DISPATCH(EnterIntoSlots)(sample, slots);
}

void CompareSlots(const SlotRows& slots, float least, bool root,
                  const ComparedRows& out) {
  HWY_DYNAMIC_DISPATCH(CompareSlotRows)(slots, least, root, out);
}

}  // namespace rtb
#endif  // HWY_ONCE
