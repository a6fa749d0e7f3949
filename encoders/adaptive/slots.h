/// @file
/// Slots: the places of a cell that may get a sample, and what one is worth.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "core/math/vec.h"
#include "encoders/adaptive/samples.h"

namespace rtb {

/// @name Slots of a cell, side by side, row by row.
/// @{
inline constexpr int kSlotColumns = 4;
inline constexpr int kSlotRows = 8;
inline constexpr int kSlots = kSlotColumns * kSlotRows;
/// @}

/// @name Slots at the sides of a cell, a bit for each.
/// @{
inline constexpr std::uint32_t kFirstColumn = 0x11111111;
inline constexpr std::uint32_t kLastColumn = 0x88888888;
inline constexpr std::uint32_t kFirstRow = 0x0000000F;
inline constexpr std::uint32_t kLastRow = 0xF0000000;
/// @}

/// A squared distance before there is a sample. Finite, as are the gains of
/// such slots.
inline constexpr float kFar2 = 1e9f;

/// How far from its slot's center a sample may lie, over all that the slot
/// has: the first one near it, which spreads samples evenly, others anywhere.
/// @{
inline constexpr float kFirstJitter = 0.5f;
inline constexpr float kJitter = 1;
/// @}

/// A sample's Voronoi cell reaches at most this times the distance to the
/// nearest other one, and a little: chosen samples lie where that is large.
/// @{
inline constexpr float kReach = 1.5f;
inline constexpr float kLeastReach = 1;
/// @}

/// Squared distance that stands for an empty slot's own extent.
inline constexpr float kEmptySlot = 1;

/// What the extent of a slot counts when one more sample lies in it: kEmptySlot
/// / (n + 1) with n samples.
inline float WithOneMore(float extent) {
  return 1 / (1 / extent + 1 / kEmptySlot);
}

/// By how much a sample lowers the error of what is shown. A mean over areas
/// that have one sample each errs by the sum of their squared areas times the
/// variances in them (stratified sampling: Cochran, "Sampling Techniques",
/// 1977, chapter 5); and the area that a sample stands for grows with the
/// squared distance from it. The root more is what experiments added: it keeps
/// texture from being passed over where two samples happen to agree.
inline float Gain(float contrast, float distance2, float extent) {
  const float area = distance2 + extent;
  return contrast * area * area * std::sqrt(area);
}

/// What is known about the slots of one cell.
struct CellSlots {
  std::array<float, kSlots> contrast;   ///< See VoronoiMap.
  std::array<float, kSlots> distance2;  ///< To the nearest sample, squared.
  std::array<float, kSlots> extent;     ///< See WithOneMore.
};

/// Center of a slot inside its cell.
inline V2f SlotCenter(int slot) {
  return {(static_cast<float>(slot % kSlotColumns) + 0.5f) / kSlotColumns,
          (static_cast<float>(slot / kSlotColumns) + 0.5f) / kSlotRows};
}

}  // namespace rtb
