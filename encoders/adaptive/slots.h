/// @file
/// Slots: the places of a cell that may get a sample, and what one is worth.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
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
/// @}

/// @name Blocks: the upper and the lower half of a cell's slots.
/// @{
inline constexpr int kBlocks = 2;
inline constexpr int kBlockSlots = kSlots / kBlocks;
inline constexpr float kBlockHeight = kCellHeight / kBlocks;
/// @}

/// A squared distance before there is a sample. Finite, as are the gains of
/// such slots.
inline constexpr float kFar2 = 1e6f;

/// How far from its slot's center a sample may lie, over all that the slot
/// has: the first one near it, which spreads samples evenly, others anywhere.
/// @{
inline constexpr float kFirstJitter = 0.5f;
inline constexpr float kJitter = 1;
/// @}

/// Squared distance that stands for an empty slot's own extent.
inline constexpr float kEmptySlot = 1;

/// What the extent of a slot counts with so many samples in it.
inline float ExtentOf(int samples) {
  return kEmptySlot / static_cast<float>(samples + 1);
}

/// By how much a sample lowers the error of what is shown, squared: gains are
/// only compared, and this way no root is needed. A mean over areas that have
/// one sample each errs by the sum of their squared areas times the variances
/// in them (stratified sampling: Cochran, "Sampling Techniques", 1977, chapter
/// 5); and the area that a sample stands for grows with the squared distance
/// from it. The root more is what experiments added: it keeps texture from
/// being passed over where two samples happen to agree.
/// @param contrast as CellSlots.
inline float Gain(float contrast, float distance2, float extent) {
  const float area = distance2 + extent;
  const float area2 = area * area;
  return contrast * (area2 * area2) * area;
}

/// @name Colors of slots: their encoded channels, 10 bits each, red first.
/// @{
inline constexpr int kChannelBits = 10;
inline constexpr float kChannelMost = (1 << kChannelBits) - 1;
inline std::uint32_t PackedColor(const Rgb& encoded) {
  const auto channel = [](float value) {
    return static_cast<std::uint32_t>(value * kChannelMost + 0.5f);
  };
  return (channel(encoded.x) << (2 * kChannelBits)) +
         (channel(encoded.y) << kChannelBits) + channel(encoded.z);
}
/// @}

/// What is known about the slots of one cell. As small as may be: all of a
/// picture's are more than what a core's caches hold.
struct alignas(64) CellSlots {
  std::array<float, kSlots> distance2;      ///< To the nearest sample, squared.
  std::array<std::uint32_t, kSlots> color;  ///< Of that.
  std::array<float, kSlots> contrast;       ///< Squared: see VoronoiMap.
  std::array<std::uint8_t, kSlots> samples;  ///< How many lie in each.
};

/// The slot of a place inside a cell.
inline std::size_t SlotAt(const V2f& position) {
  return static_cast<std::size_t>(static_cast<int>(position.y * kSlotRows) *
                                      kSlotColumns +
                                  static_cast<int>(position.x * kSlotColumns));
}

/// Center of a slot inside its cell.
inline V2f SlotCenter(int slot) {
  return {(static_cast<float>(slot % kSlotColumns) + 0.5f) / kSlotColumns,
          (static_cast<float>(slot / kSlotColumns) + 0.5f) / kSlotRows};
}

/// A place in a slot.
/// @param jitter how far it may be from the center, over what the slot has.
/// @param unit in [0, 1) each way.
/// @return inside the cell, in [0, 1): rounding makes 1 of the last ones else.
inline V2f PlaceInSlot(int slot, float jitter, const V2f& unit) {
  constexpr float kLast = 0x1.fffffep-1f;
  const V2f away =
      (unit - V2f(0.5f, 0.5f)) * V2f(jitter / kSlotColumns, jitter / kSlotRows);
  const V2f place = SlotCenter(slot) + away;
  return {std::min(place.x, kLast), std::min(place.y, kLast)};
}

}  // namespace rtb
