/// @file
/// Suggestions for mistyped names.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace rtb {

/// "did you mean `name`?" for the candidate that the fewest edits (at most a
/// third of the word's length, but one in any case) separate from `word`, or
/// "". To swap neighboring letters is one edit.
std::string DidYouMean(std::string_view word,
                       std::span<const std::string> candidates);

/// "a, b, c".
std::string JoinNames(std::span<const std::string> names);

}  // namespace rtb
