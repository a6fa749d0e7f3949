// What PTX's instructions do, for the C++ that ptx2cpp.py writes, and where
// its threads are. Numbers in registers are their bits.
#pragma once

#include <algorithm>
#include <bit>
#include <cfenv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>

struct PtxIndex {
  uint32_t x = 0, y = 0, z = 0;
};
inline thread_local PtxIndex ptx_tid, ptx_ntid, ptx_ctaid, ptx_nctaid;

/// The bits of a register or constant as a T: the lowest ones.
template <class T, class Bits>
inline T PtxGet(Bits bits) {
  if constexpr (std::is_same_v<T, bool>) {
    return bits != 0;
  } else if constexpr (std::is_floating_point_v<T>) {
    using Whole = std::conditional_t<sizeof(T) == 4, uint32_t, uint64_t>;
    return std::bit_cast<T>(static_cast<Whole>(bits));
  } else {
    return static_cast<T>(bits);
  }
}

/// A T into a register that may be wider: signed ones are sign-extended.
template <class Bits, class T>
inline void PtxSet(Bits& to, T value) {
  if constexpr (std::is_floating_point_v<T>) {
    using Whole = std::conditional_t<sizeof(T) == 4, uint32_t, uint64_t>;
    to = static_cast<Bits>(std::bit_cast<Whole>(value));
  } else {
    to = static_cast<Bits>(value);
  }
}

/// What a name without a % stands for: the address of a variable or table, or
/// what is in a register.
inline uint64_t PtxAddress(const void* place) {
  return reinterpret_cast<uintptr_t>(place);
}
inline uint64_t PtxAddress(uint64_t value) { return value; }
inline uint64_t PtxAddress(uint32_t value) { return value; }
template <class T>
inline T PtxLoad(uint64_t at, int k) {
  T value;
  std::memcpy(&value,
              reinterpret_cast<const void*>(at + sizeof(T) * unsigned(k)),
              sizeof(T));
  return value;
}
template <class T>
inline void PtxStore(uint64_t at, int k, T value) {
  std::memcpy(reinterpret_cast<void*>(at + sizeof(T) * unsigned(k)), &value,
              sizeof(T));
}

inline bool PtxNot(bool value) { return !value; }
template <class T>
inline T PtxNot(T value) {
  return static_cast<T>(~value);
}
template <class T>
inline T PtxNegate(T value) {
  if constexpr (std::is_floating_point_v<T>) {
    return -value;
  } else {
    return static_cast<T>(0 - std::make_unsigned_t<T>(value));
  }
}
template <class T>
inline T PtxAbs(T value) {
  if constexpr (std::is_floating_point_v<T>) return std::fabs(value);
  return value < 0 ? PtxNegate(value) : value;
}
/// Of a number and NaN, the number.
template <class T>
inline T PtxMin(T a, T b) {
  if constexpr (std::is_floating_point_v<T>) return std::fmin(a, b);
  return std::min(a, b);
}
template <class T>
inline T PtxMax(T a, T b) {
  if constexpr (std::is_floating_point_v<T>) return std::fmax(a, b);
  return std::max(a, b);
}
template <class T>
inline bool PtxUnordered(T a, T b) {
  if constexpr (std::is_floating_point_v<T>) return std::isunordered(a, b);
  return false;
}
template <class T>
inline T PtxSaturate(T value) {
  return value > 0 ? (value < 1 ? value : T(1)) : T(0);
}

/// The integer nearest to a whole floating-point number; NaN is 0.
template <class T, class F>
inline T PtxWhole(F value) {
  using Limits = std::numeric_limits<T>;
  if (std::isnan(value)) return 0;
  if (value <= static_cast<F>(Limits::min())) return Limits::min();
  if (value >= static_cast<F>(Limits::max())) return Limits::max();
  return static_cast<T>(value);
}

template <class T>
inline T PtxLow(T a, T b) {
  using U = std::make_unsigned_t<T>;
  return static_cast<T>(static_cast<U>(uint64_t(U(a)) * uint64_t(U(b))));
}
template <class T>
inline T PtxHigh(T a, T b) {
  __extension__ using Wide =
      std::conditional_t<std::is_signed_v<T>, __int128, unsigned __int128>;
  return static_cast<T>((Wide(a) * Wide(b)) >> (8 * sizeof(T)));
}
template <class T>
inline T PtxShiftLeft(T value, uint32_t amount) {
  using U = std::make_unsigned_t<T>;
  return amount >= 8 * sizeof(T) ? T(0) : T(U(uint64_t(U(value)) << amount));
}
template <class T>
inline T PtxShiftRight(T value, uint32_t amount) {
  return T(value >> std::min<uint32_t>(amount, 8 * sizeof(T) - 1) >>
           (amount >= 8 * sizeof(T) ? 1 : 0));
}
template <class T>
inline T PtxReverse(T value) {
  T reversed = 0;
  for (unsigned k = 0; k < 8 * sizeof(T); ++k) {
    reversed = T(reversed << 1 | (value >> k & 1));
  }
  return reversed;
}
/// Section 9.7.1, bfind: of 0 there is no highest bit.
template <class T>
inline uint32_t PtxLeading(T value) {
  return value == 0 ? ~0u : uint32_t(std::countl_zero(value));
}
template <class T>
inline uint32_t PtxHighest(T value) {
  return value == 0 ? ~0u : 8 * sizeof(T) - 1 - PtxLeading(value);
}
/// Section 9.7.1, bfi: `length` bits of a into b at `place`.
template <class T>
inline T PtxInsert(T a, T b, uint32_t place, uint32_t length) {
  using U = std::make_unsigned_t<T>;
  place &= 0xff;
  length &= 0xff;
  const U ones = length >= 8 * sizeof(T) ? ~U(0) : U((U(1) << length) - 1);
  const U mask = PtxShiftLeft<U>(ones, place);
  return T((PtxShiftLeft<U>(U(a), place) & mask) | (U(b) & ~mask));
}
/// Section 9.7.1, bfe: `length` bits from `place`, sign-extended if T is.
template <class T>
inline T PtxExtract(T a, uint32_t place, uint32_t length) {
  using U = std::make_unsigned_t<T>;
  constexpr uint32_t kBits = 8 * sizeof(T);
  place &= 0xff;
  length &= 0xff;
  if (length == 0) return 0;
  const uint32_t last = std::min(place + length - 1, kBits - 1);
  const bool negative = std::is_signed_v<T> && (U(a) >> last & 1) != 0;
  U field = place >= kBits ? U(0) : U(U(a) >> place);
  const uint32_t kept = place > last ? 0 : last - place + 1;
  if (kept < kBits) {
    const U mask = U((U(1) << kept) - 1);
    field = negative ? U(field | U(~mask)) : U(field & mask);
  }
  return T(field);
}
/// Section 9.7.9, prmt in its default mode: bytes of b:a by nibbles.
inline uint32_t PtxPermute(uint32_t a, uint32_t b, uint32_t selector) {
  const uint64_t both = uint64_t(b) << 32 | a;
  uint32_t result = 0;
  for (unsigned k = 0; k < 4; ++k) {
    const uint32_t nibble = selector >> (4 * k) & 15;
    uint32_t byte = uint32_t(both >> (8 * (nibble & 7)) & 255);
    if ((nibble & 8) != 0) byte = (byte & 128) != 0 ? 255 : 0;
    result |= byte << (8 * k);
  }
  return result;
}

/// Computes with results rounded toward zero.
template <class T, class Compute>
[[gnu::noinline]] inline T PtxTowardZero(Compute compute) {
  const int mode = std::fegetround();
  std::fesetround(FE_TOWARDZERO);
  volatile T result = compute();
  std::fesetround(mode);
  return result;
}
template <class T>
inline T PtxAddRz(T a, T b) {
  volatile T x = a, y = b;
  return PtxTowardZero<T>([&] { return x + y; });
}
template <class T>
inline T PtxMulRz(T a, T b) {
  volatile T x = a, y = b;
  return PtxTowardZero<T>([&] { return x * y; });
}
template <class T>
inline T PtxFmaRz(T a, T b, T c) {
  volatile T x = a, y = b, z = c;
  return PtxTowardZero<T>([&] { return std::fma(T(x), T(y), T(z)); });
}
