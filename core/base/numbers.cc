#include "core/base/numbers.h"

#include <cmath>

namespace rtb {
namespace {

std::string Shortest(double value) {
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
  return {buffer, end};
}

}  // namespace

Error NotExpected(const std::string& place, const std::string& text,
                  const std::string& expected) {
  return BadInput(place, "found '" + text + "', expected " + expected);
}

Result<std::int64_t> ParseInteger(const std::string& place,
                                  const std::string& text, std::int64_t low,
                                  std::int64_t high) {
  const auto value = ParseWhole<std::int64_t>(text);
  if (!value || *value < low || *value > high) {
    return Fail(NotExpected(place, text,
                            "a whole number from " + std::to_string(low) +
                                " to " + std::to_string(high)));
  }
  return *value;
}

Result<std::uint64_t> ParseSeed(const std::string& place,
                                const std::string& text) {
  const auto value = ParseWhole<std::uint64_t>(text);
  if (!value) {
    return Fail(NotExpected(place, text,
                            "a whole number from 0 to 18446744073709551615"));
  }
  return *value;
}

Result<double> ParseNumber(const std::string& place, const std::string& text,
                           double low, double high) {
  const auto value = ParseWhole<double>(text);
  if (!value || !std::isfinite(*value) || *value < low || *value > high) {
    return Fail(NotExpected(
        place, text,
        "a number from " + Shortest(low) + " to " + Shortest(high)));
  }
  return *value;
}

}  // namespace rtb
