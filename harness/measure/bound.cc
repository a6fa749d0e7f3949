#include "harness/measure/bound.h"

#include <string_view>

#include "core/base/file.h"
#include "core/base/numbers.h"
#include "encoders/glyphs/glyph_set.h"
#include "harness/measure/cache.h"
#include "harness/measure/capacity.h"
#include "harness/measure/glyph_set_name.h"
#include "harness/metrics/mse.h"
#include "harness/rasters.h"

namespace rtb {
namespace {

/// The masks that decoding would use.
Result<std::string> MasksText(const DecodeOptions& decode) {
  std::string text = std::to_string(decode.cell_width) + "x" +
                     std::to_string(decode.cell_height) +
                     (decode.masks == MaskSource::kFont ? " font" : "");
  for (const std::filesystem::path& font : FontChain(decode.font)) {
    const auto hash = Sha256File(font);
    text += " " + (hash ? *hash : std::string("none"));
  }
  return text;
}

/// All that the bound depends on, a line each.
Result<std::string> InputsOf(const Image& reference, GridSize grid,
                             std::span<const char32_t> glyphs,
                             const DecodeOptions& decode) {
  RTB_ASSIGN_OR_RETURN(const std::string masks, MasksText(decode));
  const std::span<const Rgb> pixels = reference.pixels();
  const std::string_view bytes(reinterpret_cast<const char*>(pixels.data()),
                               pixels.size_bytes());
  std::string text = "program " + ProgramIdentity() + "\nreference " +
                     Sha256(bytes) + "\ngrid " + std::to_string(grid.columns) +
                     "x" + std::to_string(grid.rows) + "\nmasks " + masks +
                     "\nglyphs";
  for (const char32_t glyph : glyphs) {
    text += " " + std::to_string(static_cast<std::uint32_t>(glyph));
  }
  return text + "\n";
}

Result<double> Compute(const Image& reference, GridSize grid,
                       std::span<const char32_t> glyphs,
                       const DecodeOptions& decode) {
  RTB_ASSIGN_OR_RETURN(const Atlas atlas,
                       MakeAtlas(glyphs, decode.cell_width, decode.cell_height,
                                 decode.masks, decode.font));
  return Capacity(reference, grid, atlas, decode.threads);
}

}  // namespace

Result<double> GlyphBound(const Image& reference, GridSize grid,
                          std::span<const char32_t> glyphs,
                          const DecodeOptions& decode,
                          const std::filesystem::path& cache) {
  if (cache.empty()) return Compute(reference, grid, glyphs, decode);
  RTB_ASSIGN_OR_RETURN(const std::string inputs,
                       InputsOf(reference, grid, glyphs, decode));
  const std::filesystem::path file = cache / CacheName("bound", inputs, ".txt");
  if (const auto text = ReadFile(file)) {
    if (const auto known = ParseWhole<double>(*text)) return *known;
  }
  RTB_ASSIGN_OR_RETURN(const double bound,
                       Compute(reference, grid, glyphs, decode));
  RTB_RETURN_IF_ERROR(WriteFileAtomically(file, ExactText(bound)));
  return bound;
}

Result<BoundResult> CompareWithBound(const std::string& spec, double mse,
                                     const std::string& glyphs, double bound) {
  // Decoded pixels are in single precision, and of candidates that are equal
  // but for noise any may have been the best.
  constexpr double kRelative = 1e-5;
  constexpr double kAbsolute = 1e-10;
  if (mse < bound * (1 - kRelative) - kAbsolute) {
    return Fail(Failure(spec, "has an MSE of " + ExactText(mse) +
                                  ", below the least that its glyphs (" +
                                  glyphs + ") can reach, " + ExactText(bound) +
                                  ": the measurement is wrong"));
  }
  BoundResult result{glyphs, bound, std::nullopt};
  if (bound > 0) result.gap = mse / bound;
  return result;
}

Result<std::optional<BoundResult>> CompareWithBound(const ErrorInput& input) {
  const CellGrid& grid = input.encoding.grid;
  RTB_ASSIGN_OR_RETURN(const Image decoded, Decode(grid, input.decode));
  RTB_ASSIGN_OR_RETURN(const RasterPair pair,
                       MatchRasters(input.reference, decoded, "--reference"));
  const PixelSize compared{pair.test.width(), pair.test.height()};
  if (compared != pair.test_size) return std::optional<BoundResult>();
  const std::vector<char32_t> glyphs = GlyphsOfRun(input.encoder, grid);
  RTB_ASSIGN_OR_RETURN(
      const double bound,
      GlyphBound(pair.reference, grid.size, glyphs, input.decode, input.cache));
  const double mse = MeanSquaredError(
      MetricInput(pair.reference, pair.test, input.decode.threads));
  RTB_ASSIGN_OR_RETURN(
      BoundResult result,
      CompareWithBound(input.spec, mse, GlyphSetName(glyphs), bound));
  return std::optional(std::move(result));
}

}  // namespace rtb
