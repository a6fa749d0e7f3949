/// @file
/// PairPool: which of a limited number of color pairs mean what.
#pragma once

#include <optional>
#include <unordered_map>
#include <vector>

namespace rtb {

/// Two colors as ncurses numbers them.
struct PairColors {
  int fg = 0;
  int bg = 0;
  bool operator==(const PairColors&) const = default;
};

/// Counts for every pair the cells that show it. A pair that no cell shows may
/// be defined anew, but not before Settle(): until then the terminal shows it.
class PairPool {
 public:
  /// @param pairs how many there are beside pair 0, which is never given out.
  explicit PairPool(int pairs);

  struct Lease {
    int pair;
    bool is_new;  ///< To be defined before it is used.
  };

  /// The pair of two colors, for one more cell; none when all are in use.
  std::optional<Lease> Acquire(const PairColors& colors);
  /// One more cell shows a pair that is in use.
  void AcquireAgain(int pair) { ++uses_[static_cast<std::size_t>(pair)]; }
  /// A pair in use with that background, else with any; 0 when there is none.
  int Substitute(const PairColors& colors) const;
  /// A cell does not show the pair any more. 0 is nothing.
  void Release(int pair) { released_.push_back(pair); }
  /// The released pairs have left the terminal.
  void Settle();

  /// Pairs in use.
  int used() const { return static_cast<int>(pairs_.size()); }

 private:
  struct Hash {
    std::size_t operator()(const PairColors& colors) const {
      constexpr std::size_t kPrime = 0x9E3779B97F4A7C15;
      return (static_cast<std::size_t>(colors.fg) << 32 ^
              static_cast<std::size_t>(colors.bg)) *
             kPrime;
    }
  };

  std::unordered_map<PairColors, int, Hash> pairs_;
  std::vector<PairColors> colors_;  ///< Of each pair.
  std::vector<int> uses_;           ///< Of each pair; [0] is nobody's.
  std::vector<int> free_;
  std::vector<int> released_;
};

}  // namespace rtb
