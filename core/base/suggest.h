/// @file
/// Suggestions for mistyped names.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace rtb {

/// "did you mean `name`?" for the candidate nearest to `word` (Levenshtein
/// distance, at most a third of the word's length but at least 1), or "".
std::string DidYouMean(std::string_view word,
                       std::span<const std::string> candidates);

/// "a, b, c".
std::string JoinNames(std::span<const std::string> names);

}  // namespace rtb
