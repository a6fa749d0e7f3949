#include "encoders/adaptive/choose_in_cells.h"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

#include "core/math/random.h"

// This file is compiled once for each target.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "encoders/adaptive/choose_in_cells.cc"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "encoders/adaptive/slot_vectors-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rtb {
namespace HWY_NAMESPACE {

/// What samples in the slots of a cell are worth while some are being chosen.
struct CellState {
  HWY_ALIGN float distance2[kSlots];
  HWY_ALIGN float extent[kSlots];
  int slot;    ///< The best one.
  float gain;  ///< Of that.
};

/// The gains of a cell's slots, to find the largest.
class Gains {
 public:
  HWY_INLINE void Put(int v, F gain) { of_[v] = gain; }

  /// Of equal ones the first. Without a branch, which would be a guess.
  HWY_INLINE void Best(CellState& state) const {
    F most = of_[0];
    for (int v = 1; v < kVectors; ++v) most = hn::Max(most, of_[v]);
    most = hn::MaxOfLanes(SlotFloats(), most);
    std::uint32_t bits = 0;
    for (int v = 0; v < kVectors; ++v) {
      bits |= BitsOf(hn::Eq(of_[v], most)) << (v * kLanes);
    }
    state.slot = std::countr_zero(bits);
    state.gain = hn::GetLane(most);
  }

 private:
  F of_[kVectors];
};

HWY_INLINE void Start(const CellSlots& slots, CellState& state) {
  Gains gains;
  for (int v = 0; v < kVectors; ++v) {
    const int i = v * kLanes;
    const F distance2 = Load(slots.distance2.data() + i);
    const F extent = ExtentsOf(slots, i);
    Store(distance2, state.distance2 + i);
    Store(extent, state.extent + i);
    gains.Put(v, GainOf(Load(slots.contrast.data() + i), distance2, extent));
  }
  gains.Best(state);
}

/// An extent after one more sample.
HWY_INLINE float WithOneMore(float extent) {
  // The usual one needs no division.
  if (extent == kEmptySlot) return ExtentOf(1);
  return ExtentOf(static_cast<int>(kEmptySlot / extent + 0.5f));
}

/// Counts on a sample in the best slot.
HWY_INLINE void Expect(const CellSlots& slots, float cell_width,
                       const V2f& position, CellState& state) {
  const float x = position.x * cell_width;
  const float y = position.y * kCellHeight;
  const float after = WithOneMore(state.extent[state.slot]);
  const F at = Same(static_cast<float>(state.slot));
  Gains gains;
  for (int v = 0; v < kVectors; ++v) {
    const int i = v * kLanes;
    const F distance2 =
        hn::Min(Load(state.distance2 + i), DistanceOf(i, cell_width, x, y));
    const auto here = hn::Eq(hn::Iota(SlotFloats(), static_cast<float>(i)), at);
    const F extent = hn::IfThenElse(here, Same(after), Load(state.extent + i));
    Store(distance2, state.distance2 + i);
    Store(extent, state.extent + i);
    gains.Put(v, GainOf(Load(slots.contrast.data() + i), distance2, extent));
  }
  gains.Best(state);
}

/// Where a sample goes in the best slot.
/// @param unit random, in [0, 1) each way.
HWY_INLINE V2f Jittered(const CellState& state, const V2f& unit) {
  const bool first = state.extent[state.slot] == kEmptySlot;
  return PlaceInSlot(state.slot, first ? kFirstJitter : kJitter, unit);
}

/// The cells in which more is to be chosen, as indices.
struct Open {
  std::array<std::uint32_t, kCellsAtOnce> cells{};
  std::size_t count = 0;

  /// Without a branch, which would be a guess.
  HWY_INLINE void Add(std::size_t cell, bool open) {
    cells[count] = static_cast<std::uint32_t>(cell);
    count += static_cast<std::size_t>(open);
  }
};

/// Where the i-th rays of the open cells go in their slots. A loop of its own,
/// which compilers turn into vectors.
struct RandomPlaces {
  std::array<std::uint32_t, kCellsAtOnce> cell, number;
  std::array<float, kCellsAtOnce> x, y;

  HWY_FLATTEN void Draw(std::size_t count, std::uint64_t seed) {
    for (std::size_t n = 0; n < count; ++n) {
      x[n] = UnitFloat(RandomBits(cell[n], number[n], 0, seed));
      y[n] = UnitFloat(RandomBits(cell[n], number[n], 1, seed));
    }
  }
};

/// One ray in each cell, then the next: what one waits for hinders no other.
void Choose(std::span<const CellChoice> cells, const ChoiceTerms& terms,
            std::size_t room, RayChoice* out, int* counts) {
  std::array<CellState, kCellsAtOnce> states;
  RandomPlaces random;
  Open open, next;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    Start(*cells[c].slots, states[c]);
    counts[c] = 0;
    open.Add(c, states[c].gain >= terms.least);
  }
  for (int i = 0; open.count > 0; ++i) {
    for (std::size_t n = 0; n < open.count; ++n) {
      const CellChoice& choice = cells[open.cells[n]];
      random.cell[n] = static_cast<std::uint32_t>(choice.cell);
      random.number[n] = static_cast<std::uint32_t>(choice.seen + i);
    }
    random.Draw(open.count, terms.seed);
    next.count = 0;
    for (std::size_t n = 0; n < open.count; ++n) {
      const std::size_t c = open.cells[n];
      const CellChoice& choice = cells[c];
      CellState& state = states[c];
      const V2f position = Jittered(state, V2f(random.x[n], random.y[n]));
      out[c * room + static_cast<std::size_t>(i)] = {choice.cell, position,
                                                     state.gain};
      counts[c] = i + 1;
      if (i + 1 == choice.most) continue;
      Expect(*choice.slots, terms.cell_width, position, state);
      next.Add(c, state.gain >= terms.least);
    }
    std::swap(open, next);
  }
}

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace rtb
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rtb {

HWY_EXPORT(Choose);

void ChooseInCells(std::span<const CellChoice> cells, const ChoiceTerms& terms,
                   std::size_t room, RayChoice* out, int* counts) {
  HWY_DYNAMIC_DISPATCH(Choose)(cells, terms, room, out, counts);
}

}  // namespace rtb
#endif  // HWY_ONCE
