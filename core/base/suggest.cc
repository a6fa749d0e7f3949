#include "core/base/suggest.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace rtb {
namespace {

/// Edits (insert, delete, replace, swap neighbors) that turn `a` into `b`:
/// the restricted distance of Damerau, "A technique for computer detection and
/// correction of spelling errors", 1964, by dynamic programming.
std::size_t EditDistance(std::string_view a, std::string_view b) {
  // edits[i][j] turn the first i characters of a into the first j of b.
  std::vector<std::vector<std::size_t>> edits(
      a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  std::iota(edits[0].begin(), edits[0].end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    edits[i][0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced =
          edits[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      edits[i][j] =
          std::min({replaced, edits[i - 1][j] + 1, edits[i][j - 1] + 1});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        edits[i][j] = std::min(edits[i][j], edits[i - 2][j - 2] + 1);
      }
    }
  }
  return edits[a.size()][b.size()];
}

}  // namespace

std::string DidYouMean(std::string_view word,
                       std::span<const std::string> candidates) {
  // What nobody typed by mistake needs no suggestion - nor quadratic work.
  if (word.size() > 64) return "";
  std::size_t best = std::max<std::size_t>(1, word.size() / 3) + 1;
  const std::string* nearest = nullptr;
  for (const std::string& candidate : candidates) {
    const std::size_t distance = EditDistance(word, candidate);
    if (distance < best) {
      best = distance;
      nearest = &candidate;
    }
  }
  return nearest == nullptr ? "" : "did you mean `" + *nearest + "`?";
}

std::string JoinNames(std::span<const std::string> names) {
  std::string text;
  for (const std::string& name : names) {
    if (!text.empty()) text += ", ";
    text += name;
  }
  return text;
}

}  // namespace rtb
