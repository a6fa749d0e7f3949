/// @file
/// GainThreshold: about what the last of the wanted rays gains.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace rtb {

/// Counts gains (0 or more) in classes of 1/16 of a power of 2.
class GainThreshold {
 public:
  /// @param counts whether to count it at all.
  void Add(float gain, bool counts = true) {
    const std::size_t place = ClassOf(gain);
    // Without a branch, which would be a guess.
    counts_[place] += counts ? 1 : 0;
    end_ = std::max(end_, place + 1);
  }

  /// Where the count-th largest gain lies.
  struct Class {
    float from = 0;  ///< Its class: [from, to); [0, infinity) with fewer.
    float to = std::numeric_limits<float>::infinity();
    int above = 0;  ///< Gains in the classes above.
  };
  Class Of(int count) const {
    int above = 0;
    for (std::size_t i = end_; i-- > 0;) {
      if (above + counts_[i] >= count) {
        return {LowerEnd(i), LowerEnd(i + 1), above};
      }
      above += counts_[i];
    }
    return {};
  }

 private:
  static constexpr int kShift = 19;  // Of 23 bits of the fraction 4 stay.
  static constexpr std::size_t kClasses = std::size_t{1} << (31 - kShift);

  static std::size_t ClassOf(float gain) {
    return std::bit_cast<std::uint32_t>(gain) >> kShift;
  }
  static float LowerEnd(std::size_t place) {
    return std::bit_cast<float>(static_cast<std::uint32_t>(place) << kShift);
  }

  std::array<int, kClasses> counts_{};
  std::size_t end_ = 0;  ///< No class from here on has any.
};

}  // namespace rtb
