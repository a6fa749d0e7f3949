/// @file
/// sobol.h and the sines of angles on vectors (Highway; for inclusion per
/// target).

// Highway's guard, which flips with each target, in place of #pragma once.
#if defined(RTB_CORE_RENDER_WIDE_RANDOM_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTB_CORE_RENDER_WIDE_RANDOM_INL_H_
#undef RTB_CORE_RENDER_WIDE_RANDOM_INL_H_
#else
#define RTB_CORE_RENDER_WIDE_RANDOM_INL_H_
#endif

#include <hwy/highway.h>

#include <cmath>
#include <cstdint>

#include "core/math/sin_cos.h"
#include "core/math/sobol.h"
#include "core/render/wide/lanes-inl.h"
#include "core/render/wide/sobol_tables.h"

HWY_BEFORE_NAMESPACE();
namespace rtb {
namespace HWY_NAMESPACE {
namespace wide {

struct U4 {
  U x, y, z, w;
};

/// Pcg4d of random.h.
HWY_INLINE U4 Pcg4d(U4 v) {
  const U factor = SetU(1664525u), increment = SetU(1013904223u);
  v = {v.x * factor + increment, v.y * factor + increment,
       v.z * factor + increment, v.w * factor + increment};
  const auto mix = [&v] {
    v.x = v.x + v.y * v.w;
    v.y = v.y + v.z * v.x;
    v.z = v.z + v.x * v.y;
    v.w = v.w + v.y * v.z;
  };
  mix();
  v = {v.x ^ hn::ShiftRight<16>(v.x), v.y ^ hn::ShiftRight<16>(v.y),
       v.z ^ hn::ShiftRight<16>(v.z), v.w ^ hn::ShiftRight<16>(v.w)};
  mix();
  return v;
}

/// The same of a value in each lane and three that all have in common, only x.
HWY_INLINE U Pcg4dOf(U x, std::uint32_t y, std::uint32_t z, std::uint32_t w) {
  const auto step = [](std::uint32_t v) { return v * 1664525u + 1013904223u; };
  y = step(y);
  z = step(z);
  w = step(w);
  U vx = x * SetU(1664525u) + SetU(1013904223u + y * w);
  U vy = SetU(y) + SetU(z) * vx;
  const U vz = SetU(z) + vx * vy;
  U vw = SetU(w) + vy * vz;
  vx = vx ^ hn::ShiftRight<16>(vx);
  vy = vy ^ hn::ShiftRight<16>(vy);
  vw = vw ^ hn::ShiftRight<16>(vw);
  return vx + vy * vw;
}

/// UnitFloat of random.h.
HWY_INLINE F UnitFloat(U bits) {
  return hn::ConvertTo(DF(), hn::BitCast(DI(), hn::ShiftRight<8>(bits))) *
         Set(0x1p-24f);
}

#if HWY_TARGET == HWY_SCALAR
HWY_INLINE U ReverseBits(U v) { return SetU(rtb::ReverseBits(v.raw)); }
#else
HWY_INLINE U ReverseBits(U v) {
  alignas(16) static constexpr std::uint8_t kReversed[16] = {
      0, 8, 4, 12, 2, 10, 6, 14, 1, 9, 5, 13, 3, 11, 7, 15};
  alignas(16) static constexpr std::uint8_t kBytes[16] = {
      3, 2, 1, 0, 7, 6, 5, 4, 11, 10, 9, 8, 15, 14, 13, 12};
  const hn::Repartition<std::uint8_t, DU> bytes;
  const auto reversed = hn::LoadDup128(bytes, kReversed);
  const U nibble = SetU(0x0F0F0F0Fu);
  const auto low = hn::BitCast(bytes, hn::And(v, nibble));
  const auto high = hn::BitCast(bytes, hn::And(hn::ShiftRight<4>(v), nibble));
  const U upper = hn::BitCast(DU(), hn::TableLookupBytes(reversed, low));
  const auto lower = hn::TableLookupBytes(reversed, high);
  const auto all = hn::Or(hn::BitCast(bytes, hn::ShiftLeft<4>(upper)), lower);
  return hn::BitCast(DU(),
                     hn::TableLookupBytes(all, hn::LoadDup128(bytes, kBytes)));
}
#endif

HWY_INLINE U ScrambleReversed(U v, U seed) {
  v = v ^ (v * SetU(0x3D20ADEAu));
  v = v + seed;
  v = v * hn::Or(hn::ShiftRight<16>(seed), SetU(1));
  v = v ^ (v * SetU(0x05526C56u));
  return v ^ (v * SetU(0x53A22864u));
}

/// The points of SobolOwen4, as far as they are wanted.
class SobolPoint {
 public:
  /// @param set,seed the same for all lanes.
  SobolPoint(U pattern, U index, std::uint32_t set, std::uint64_t seed) {
    const U own = SeedOf(pattern, set, seed);
    hash_ = Pcg4d({own, SetU(0x2545F491u), SetU(0x4F6CDD1Du), SetU(4)});
    index_ = ReverseBits(ScrambleReversed(ReverseBits(index), hash_.x));
  }

  HWY_INLINE F x() const { return Scrambled(index_, hash_.y); }
  HWY_INLINE F y() const { return Scrambled(Reversed<0>(), hash_.z); }
  HWY_INLINE F z() const { return Scrambled(Reversed<1>(), hash_.w); }
  HWY_INLINE F w() const { return Scrambled(Reversed<2>(), Pcg4d(hash_).x); }

 private:
  /// SobolSeed, by RandomBits.
  static HWY_INLINE U SeedOf(U pattern, std::uint32_t set, std::uint64_t seed) {
    constexpr std::uint32_t kPurpose = 0x50B01u;
    const auto high = static_cast<std::uint32_t>(seed >> 32);
    return Pcg4dOf(pattern, kPurpose, set ^ (high * 0x9E3779B9u),
                   static_cast<std::uint32_t>(seed));
  }

  /// SobolReversed, by as many bits of the index at a time as a table of one
  /// entry a lane has room for.
  template <int kRow>
  HWY_INLINE U Reversed() const {
#if HWY_TARGET == HWY_SCALAR
    return SetU(SobolReversed(index_.raw, kRow + 1));
#else
    static constexpr SobolTables<hn::MaxLanes(DU())> kTables =
        MakeSobolTables<hn::MaxLanes(DU())>(kRow);
    U sum = hn::Zero(DU());
    U left = index_;
    for (const auto& entries : kTables.sums) {
      const U digit = hn::And(left, SetU(hn::MaxLanes(DU()) - 1));
      sum = sum ^ hn::TableLookupLanes(hn::Load(DU(), entries),
                                       hn::IndicesFromVec(DU(), digit));
      left = hn::ShiftRight<kTables.kBits>(left);
    }
    return sum;
#endif
  }

  static HWY_INLINE F Scrambled(U reversed, U seed) {
    return UnitFloat(ReverseBits(ScrambleReversed(reversed, seed)));
  }

  U4 hash_;
  U index_;
};

struct SinCos {
  F sine, cosine;
};

/// The very operations of SinCosOf in sin_cos.h, for angles 0 .. 2 pi.
HWY_INLINE void SinCosOf(D x, D* sine, D* cosine) {
  using T = SinCosTerms;
  const auto set = [](double value) { return hn::Set(DD(), value); };
  const D turns = hn::Floor(x * set(T::kQuartersPerRadian) + set(0.5));
  const D y = (x - turns * set(T::kQuarterHigh)) - turns * set(T::kQuarterLow);
  const D y2 = y * y;
  const D y4 = y2 * y2;
  const D c = (set(1) + y2 * set(T::kC1) + y4 * set(T::kC2)) +
              y4 * y2 * (set(T::kC3) + y2 * set(T::kC4));
  const D s =
      (y + y * y2 * set(T::kS1)) + y * y4 * (set(T::kS2) + y2 * set(T::kS3));
  const auto one = turns == set(1), two = turns == set(2),
             three = turns == set(3);
  const auto swap = hn::Or(one, three);
  const D sine_size = hn::IfThenElse(swap, c, s);
  const D cosine_size = hn::IfThenElse(swap, s, c);
  *sine = hn::IfThenElse(hn::Or(two, three), hn::Neg(sine_size), sine_size);
  *cosine = hn::IfThenElse(hn::Or(one, two), hn::Neg(cosine_size), cosine_size);
}

HWY_INLINE SinCos SinCosOf(F angle) {
  D s0, c0, s1, c1;
  SinCosOf(LowerDoubles(angle), &s0, &c0);
  SinCosOf(UpperDoubles(angle), &s1, &c1);
  return {Floats(s0, s1), Floats(c0, c1)};
}

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace wide
}  // namespace HWY_NAMESPACE
}  // namespace rtb
HWY_AFTER_NAMESPACE();

#endif  // RTB_CORE_RENDER_WIDE_RANDOM_INL_H_
