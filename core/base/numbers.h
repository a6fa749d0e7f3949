/// @file
/// Numbers from text. Errors say what was found and what is expected.
#pragma once

#include <charconv>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace rtb {

/// The whole text as a number of type T; nothing else may stand around it.
template <class T>
std::optional<T> ParseWhole(std::string_view text) {
  T value{};
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end) return std::nullopt;
  return value;
}

/// The error for a text that is not what was expected.
Error NotExpected(const std::string& place, const std::string& text,
                  const std::string& expected);

/// A whole number in [low, high]. @param place names the argument.
Result<std::int64_t> ParseInteger(const std::string& place,
                                  const std::string& text, std::int64_t low,
                                  std::int64_t high);

/// A whole number in [0, 2^64).
Result<std::uint64_t> ParseSeed(const std::string& place,
                                const std::string& text);

/// A finite number in [low, high].
Result<double> ParseNumber(const std::string& place, const std::string& text,
                           double low, double high);

}  // namespace rtb
