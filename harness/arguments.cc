#include "harness/arguments.h"

#include <optional>
#include <string_view>

namespace rtb {
namespace {

/// `AxB` with both in 1..limit.
Result<PixelSize> ParsePair(const std::string& place, const std::string& text,
                            int limit, const std::string& expected) {
  const std::size_t x = text.find('x');
  if (x == std::string::npos) return Fail(NotExpected(place, text, expected));
  const std::string_view view = text;
  const auto a = ParseWhole<int>(view.substr(0, x));
  const auto b = ParseWhole<int>(view.substr(x + 1));
  const auto fits = [limit](const std::optional<int>& side) {
    return side && *side >= 1 && *side <= limit;
  };
  if (!fits(a) || !fits(b)) return Fail(NotExpected(place, text, expected));
  return PixelSize{*a, *b};
}

std::string SidesUpTo(int limit) {
  return ", each 1 to " + std::to_string(limit);
}

}  // namespace

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
    return Fail(NotExpected(place, text, expected));
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
