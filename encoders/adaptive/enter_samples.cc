#include <hwy/cache_control.h>

#include <algorithm>
#include <array>

#include "encoders/adaptive/slot_kernels.h"

// This file is compiled once for each target.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "encoders/adaptive/enter_samples.cc"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "encoders/adaptive/sample_visits-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rtb {
namespace HWY_NAMESPACE {

/// Samples that are to be counted in their own slots.
class Counted {
 public:
  HWY_INLINE explicit Counted(const SlotGrid& slots) : slots_(slots) {}

  HWY_INLINE void Add(const SeenSample& sample, std::ptrdiff_t cell) {
    hwy::Prefetch(slots_.cells[cell].samples.data());
    cells_[count_] = cell;
    places_[count_++] = SlotAt(sample.position);
  }

  HWY_INLINE void Enter() const {
    for (std::size_t i = 0; i < count_; ++i) {
      slots_.changed[cells_[i]] |= std::uint32_t{1} << places_[i];
      ++slots_.cells[cells_[i]].samples[places_[i]];
    }
  }

 private:
  const SlotGrid& slots_;
  std::size_t count_ = 0;
  std::array<std::ptrdiff_t, kTogether> cells_;
  std::array<std::size_t, kTogether> places_;
};

void EnterAll(std::span<const SeenSample> samples, int first, int last,
              const SlotGrid& slots) {
  Visits visits(slots, first, last);
  const int columns = slots.grid.columns;
  int row = 0;
  while (!samples.empty()) {
    const auto some = samples.first(std::min(kTogether, samples.size()));
    samples = samples.subspan(some.size());
    visits.Clear();
    Counted counted(slots);
    for (const SeenSample& sample : some) {
      while (sample.cell >= (row + 1) * columns) ++row;
      const Place place = {slots.At(sample.cell - row * columns, row), row,
                           static_cast<int>(sample.position.y * kBlocks)};
      // Others are too far away.
      const int nearest =
          row < first ? row + place.half : row - (1 - place.half);
      if (row < first ? nearest < first : nearest > last) continue;
      visits.Add(sample, place);
      if (row >= first && row <= last) counted.Add(sample, place.cell);
    }
    visits.Enter();
    counted.Enter();
  }
}

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace rtb
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rtb {

HWY_EXPORT(EnterAll);

void EnterSamples(std::span<const SeenSample> samples, int first, int last,
                  const SlotGrid& slots) {
  HWY_DYNAMIC_DISPATCH(EnterAll)(samples, first, last, slots);
}

}  // namespace rtb
#endif  // HWY_ONCE
