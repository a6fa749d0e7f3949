/// @file
/// Vectors whose lanes are cells, arrays of them, and how they are filled from
/// memory that holds one cell's values after the other's. For inclusion per
/// target (Highway).

// Highway's guard, which flips with each target, in place of #pragma once.
#if defined(RTB_ENCODERS_SIMD_TRANSPOSE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTB_ENCODERS_SIMD_TRANSPOSE_INL_H_
#undef RTB_ENCODERS_SIMD_TRANSPOSE_INL_H_
#else
#define RTB_ENCODERS_SIMD_TRANSPOSE_INL_H_
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace rtb {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using FloatLanes = hn::ScalableTag<float>;
using IntLanes = hn::RebindToSigned<FloatLanes>;
using Floats = hn::Vec<FloatLanes>;
using Ints = hn::Vec<IntLanes>;
using FloatMask = hn::Mask<FloatLanes>;

/// Room for one value in each lane.
constexpr std::size_t kMaxLanes = hn::MaxLanes(FloatLanes());

/// kCount vectors in memory, one after the other.
template <std::size_t kCount, class T = float>
struct LaneArray {
  using Lanes = hn::ScalableTag<T>;

  HWY_ALIGN_MAX T values[kCount * kMaxLanes];

  hn::Vec<Lanes> operator[](std::size_t i) const {
    return hn::Load(Lanes(), values + i * kMaxLanes);
  }
  void Set(std::size_t i, hn::Vec<Lanes> v) {
    hn::Store(v, Lanes(), values + i * kMaxLanes);
  }
};

#if HWY_TARGET != HWY_SCALAR

/// 4 values of one cell; bytes need no alignment.
template <class D, class T>
HWY_INLINE hn::Vec<D> LoadBlock(D d, const T* values) {
  const hn::Repartition<std::uint8_t, D> d8;
  return hn::BitCast(
      d, hn::LoadU(d8, reinterpret_cast<const std::uint8_t*>(values)));
}

/// Block j holds 4 values of cell `first` + 4 j, which is `stride` values long.
template <class D, class T>
HWY_INLINE hn::Vec<D> LoadBlocks(D d, const T* values, std::size_t stride,
                                 std::size_t first) {
  if constexpr (hn::MaxLanes(D()) <= 4) {
    return LoadBlock(d, values + first * stride);
  } else {
    const hn::Half<D> half;
    constexpr std::size_t kHalf = hn::MaxLanes(hn::Half<D>());
    return hn::Combine(d, LoadBlocks(half, values, stride, first + kHalf),
                       LoadBlocks(half, values, stride, first));
  }
}

/// The 4 values of each cell from `values` on, one a vector: the columns of
/// the 4 x 4 matrices that four vectors' blocks make up.
template <class D, class T>
HWY_INLINE void LoadFour(D d, const T* values, std::size_t stride,
                         hn::Vec<D> (&columns)[4]) {
  const hn::Repartition<std::uint64_t, D> d64;
  const auto a = LoadBlocks(d, values, stride, 0);
  const auto b = LoadBlocks(d, values, stride, 1);
  const auto c = LoadBlocks(d, values, stride, 2);
  const auto e = LoadBlocks(d, values, stride, 3);
  const auto ab_low = hn::BitCast(d64, hn::InterleaveLower(d, a, b));
  const auto ce_low = hn::BitCast(d64, hn::InterleaveLower(d, c, e));
  const auto ab_high = hn::BitCast(d64, hn::InterleaveUpper(d, a, b));
  const auto ce_high = hn::BitCast(d64, hn::InterleaveUpper(d, c, e));
  columns[0] = hn::BitCast(d, hn::InterleaveLower(d64, ab_low, ce_low));
  columns[1] = hn::BitCast(d, hn::InterleaveUpper(d64, ab_low, ce_low));
  columns[2] = hn::BitCast(d, hn::InterleaveLower(d64, ab_high, ce_high));
  columns[3] = hn::BitCast(d, hn::InterleaveUpper(d64, ab_high, ce_high));
}

/// Vector i holds value i of each cell, a cell being kValues values.
template <std::size_t kValues, class D, class T, class Array>
HWY_INLINE void Transpose(D d, const T* values, Array& lanes) {
  for (std::size_t i = 0; i < kValues; i += 4) {
    // The last block reaches back instead of beyond the end.
    const std::size_t begin = std::min(i, kValues - 4);
    hn::Vec<D> columns[4];
    LoadFour(d, values + begin, kValues, columns);
    for (std::size_t j = i - begin; j < 4; ++j) {
      lanes.Set(begin + j, columns[j]);
    }
  }
}

#else  // One lane: there is nothing to turn.

template <std::size_t kValues, class D, class T, class Array>
HWY_INLINE void Transpose(D d, const T* values, Array& lanes) {
  for (std::size_t i = 0; i < kValues; ++i) {
    lanes.Set(i, hn::Load(d, values + i));
  }
}

#endif
// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace rtb
HWY_AFTER_NAMESPACE();

#endif  // RTB_ENCODERS_SIMD_TRANSPOSE_INL_H_
