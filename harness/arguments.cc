#include "harness/arguments.h"

#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

namespace rtb {
namespace {

/// The whole text as a number of type T; nothing else may stand around it.
template <class T>
std::optional<T> Whole(std::string_view text) {
  T value{};
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end) return std::nullopt;
  return value;
}

std::string Shortest(double value) {
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
  return {buffer, end};
}

Error Expected(const std::string& place, const std::string& text,
               const std::string& expected) {
  return BadInput(place, "found '" + text + "', expected " + expected);
}

/// `AxB` with both in 1..limit.
Result<PixelSize> ParsePair(const std::string& place, const std::string& text,
                            int limit, const std::string& expected) {
  const std::size_t x = text.find('x');
  if (x == std::string::npos) return Fail(Expected(place, text, expected));
  const std::string_view view = text;
  const auto a = Whole<int>(view.substr(0, x));
  const auto b = Whole<int>(view.substr(x + 1));
  const auto fits = [limit](const std::optional<int>& side) {
    return side && *side >= 1 && *side <= limit;
  };
  if (!fits(a) || !fits(b)) return Fail(Expected(place, text, expected));
  return PixelSize{*a, *b};
}

std::string SidesUpTo(int limit) {
  return ", each 1 to " + std::to_string(limit);
}

}  // namespace

Result<std::int64_t> ParseInteger(const std::string& place,
                                  const std::string& text, std::int64_t low,
                                  std::int64_t high) {
  const auto value = Whole<std::int64_t>(text);
  if (!value || *value < low || *value > high) {
    return Fail(Expected(place, text,
                         "a whole number from " + std::to_string(low) + " to " +
                             std::to_string(high)));
  }
  return *value;
}

Result<std::uint64_t> ParseSeed(const std::string& place,
                                const std::string& text) {
  const auto value = Whole<std::uint64_t>(text);
  if (!value) {
    return Fail(
        Expected(place, text, "a whole number from 0 to 18446744073709551615"));
  }
  return *value;
}

Result<double> ParseNumber(const std::string& place, const std::string& text,
                           double low, double high) {
  const auto value = Whole<double>(text);
  if (!value || !std::isfinite(*value) || *value < low || *value > high) {
    return Fail(
        Expected(place, text,
                 "a number from " + Shortest(low) + " to " + Shortest(high)));
  }
  return *value;
}

Result<GridSize> ParseGrid(const std::string& place, const std::string& text) {
  RTB_ASSIGN_OR_RETURN(
      const PixelSize pair,
      ParsePair(place, text, kMaxGridSide,
                "COLSxROWS such as 120x40" + SidesUpTo(kMaxGridSide)));
  return GridSize{pair.width, pair.height};
}

Result<PixelSize> ParseImageSize(const std::string& place,
                                 const std::string& text) {
  const std::string expected = "WIDTHxHEIGHT such as 960x640" +
                               SidesUpTo(kMaxImageSide) + ", at most " +
                               std::to_string(kMaxSamples) + " pixels";
  RTB_ASSIGN_OR_RETURN(const PixelSize size,
                       ParsePair(place, text, kMaxImageSide, expected));
  if (std::int64_t{size.width} * size.height > kMaxSamples) {
    return Fail(Expected(place, text, expected));
  }
  return size;
}

Result<PixelSize> ParseCellSize(const std::string& place,
                                const std::string& text) {
  return ParsePair(place, text, kMaxCellSide,
                   "WIDTHxHEIGHT such as 8x16" + SidesUpTo(kMaxCellSide));
}

Status CheckSampleCount(const std::string& place, const SamplePlan& plan) {
  const std::size_t samples = plan.samples();
  if (samples <= static_cast<std::size_t>(kMaxSamples)) return {};
  return Fail(BadInput(place,
                       "asks for " + std::to_string(samples) +
                           " samples, at most " + std::to_string(kMaxSamples) +
                           " are possible",
                       "take a smaller grid"));
}

Result<PixelSize> RasterSize(GridSize grid, PixelSize cell) {
  const std::int64_t width = std::int64_t{grid.columns} * cell.width;
  const std::int64_t height = std::int64_t{grid.rows} * cell.height;
  if (width > kMaxRasterPixels || height > kMaxRasterPixels ||
      width * height > kMaxRasterPixels) {
    return Fail(BadInput("--grid",
                         "decodes to " + std::to_string(width) + "x" +
                             std::to_string(height) + " pixels, at most " +
                             std::to_string(kMaxRasterPixels) + " are possible",
                         "take a smaller grid or a smaller --cell"));
  }
  return PixelSize{static_cast<int>(width), static_cast<int>(height)};
}

}  // namespace rtb
