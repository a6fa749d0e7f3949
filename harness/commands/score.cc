#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "core/base/file.h"
#include "core/image/io.h"
#include "encoders/parse/parse.h"
#include "harness/cell_difference.h"
#include "harness/cell_shape.h"
#include "harness/commands/command.h"
#include "harness/commands/console.h"
#include "harness/commands/options.h"
#include "harness/error_maps.h"
#include "harness/metrics/flip_map.h"
#include "harness/metrics/hdr_flip.h"
#include "harness/metrics/metric.h"
#include "harness/rasters.h"
#include "harness/results/run_record_json.h"

namespace rtb {
namespace {

struct ScoreOptions {
  std::string reference;
  std::string image;
  std::string ansi;
  std::string cells;
  std::string against;
  GridSize grid;  ///< 0x0 = not given.
  double exposure = 0;
  DecodeOptions decode;
  int threads = 0;
  std::string maps;  ///< Folder of pictures of the errors; empty: none.
  std::string json;
};

Result<std::string> ReadText(const std::string& source) {
  return source == "-" ? ReadStandardInput() : ReadFile(source);
}

Result<CellGrid> ReadCells(const std::string& source) {
  RTB_ASSIGN_OR_RETURN(const std::string text, ReadText(source));
  return ParseCellsJson(text, source == "-" ? "standard input" : source);
}

Result<CellGrid> ReadGrid(const ScoreOptions& options) {
  if (!options.cells.empty()) return ReadCells(options.cells);
  if (options.grid.cells() == 0) {
    return Fail(BadInput("--ansi", "needs the size of its grid",
                         "add --grid=COLSxROWS"));
  }
  RTB_ASSIGN_OR_RETURN(const std::string text, ReadText(options.ansi));
  return ParseAnsi(text, options.grid);
}

/// The raster to score, sRGB-encoded.
Result<Image> ReadTest(const ScoreOptions& options) {
  if (!options.image.empty()) {
    return ReadDisplayed(options.image, options.exposure);
  }
  RTB_ASSIGN_OR_RETURN(const CellGrid grid, ReadGrid(options));
  RTB_RETURN_IF_ERROR(RasterSize(grid.size, CellOf(options.decode)));
  DecodeOptions decode = options.decode;
  decode.threads = options.threads;
  return Decode(grid, decode);
}

/// `name value` lines; `-` where undefined.
std::string Lines(const Json& values) {
  std::string text;
  for (const auto& [name, value] : values.items()) {
    char line[96];
    if (value.is_number_float()) {
      std::snprintf(line, sizeof line, "%-14s %.6g\n", name.c_str(),
                    value.get<double>());
    } else {
      std::snprintf(line, sizeof line, "%-14s %s\n", name.c_str(),
                    value.is_null() ? "-" : value.dump().c_str());
    }
    text += line;
  }
  return text;
}

/// Lines under a title on standard output, and JSON where it is asked for.
Status Report(const Json& document, const Json& values,
              const std::string& title, const ScoreOptions& options) {
  if (!options.json.empty()) {
    RTB_RETURN_IF_ERROR(WriteJson(options.json, document));
  }
  if (options.json == "-") return {};
  return WriteOutput("-", title + Lines(values));
}

/// A FLIP value says nothing without its pixels per degree and its raster.
Status ReportScores(const std::vector<MetricValue>& scores, const Image& raster,
                    const ScoreOptions& options) {
  const Json values = MetricsToJson(scores);
  const std::string size =
      std::to_string(raster.width()) + "x" + std::to_string(raster.height());
  return Report(Json{{"schema", 1},
                     {"metrics", values},
                     {"ppd", kFlipPpd},
                     {"raster", {raster.width(), raster.height()}}},
                values,
                "compared at " + size +
                    " pixels; flip and flip_p95 at 40 "
                    "pixels per degree\n",
                options);
}

/// Pictures of where the errors are.
Status WriteMaps(const RasterPair& pair, const ScoreOptions& options) {
  const MetricInput input(pair.reference, pair.test, options.threads);
  const std::filesystem::path folder(options.maps);
  for (const auto& [name, map] :
       {std::pair{"flip.png", FlipPicture(input)},
        {"difference.png", DifferencePicture(input)}}) {
    RTB_ASSIGN_OR_RETURN(const std::string png, EncodePng(map));
    RTB_RETURN_IF_ERROR(WriteFileAtomically(folder / name, png));
  }
  return {};
}

/// HDR-FLIP, where reference and test are linear renders.
Status ScoreLinear(const ScoreOptions& options,
                   std::vector<MetricValue>& scores) {
  if (options.image.empty() || !HoldsLinearLight(options.image) ||
      !HoldsLinearLight(options.reference)) {
    return {};
  }
  RTB_ASSIGN_OR_RETURN(const Image reference, ReadLinear(options.reference));
  RTB_ASSIGN_OR_RETURN(const Image test, ReadLinear(options.image));
  const auto flip = HdrFlip(reference, test, options.threads);
  if (!flip) {
    PrintNote(flip.error().ToString());
    return {};
  }
  *std::ranges::find(scores, "hdr_flip", &MetricValue::name) = {"hdr_flip",
                                                                *flip};
  return {};
}

Status ScoreAgainstReference(const ScoreOptions& options) {
  RTB_ASSIGN_OR_RETURN(const Image test, ReadTest(options));
  RTB_ASSIGN_OR_RETURN(const Image reference,
                       ReadDisplayed(options.reference, options.exposure));
  RTB_ASSIGN_OR_RETURN(const RasterPair pair,
                       MatchRasters(reference, test, "--reference"));
  RTB_ASSIGN_OR_RETURN(std::vector<MetricValue> scores,
                       Score(pair.reference, pair.test, options.threads));
  RTB_RETURN_IF_ERROR(ScoreLinear(options, scores));
  if (!options.maps.empty()) RTB_RETURN_IF_ERROR(WriteMaps(pair, options));
  return ReportScores(scores, pair.test, options);
}

Status CompareGrids(const ScoreOptions& options) {
  RTB_ASSIGN_OR_RETURN(const CellGrid a, ReadCells(options.cells));
  RTB_ASSIGN_OR_RETURN(const CellGrid b, ReadCells(options.against));
  RTB_ASSIGN_OR_RETURN(const CellDifference difference, CompareCells(a, b));
  const Json values{{"total", difference.total},
                    {"cells", difference.cells},
                    {"glyphs", difference.glyphs},
                    {"colors", difference.colors}};
  return Report(Json{{"schema", 1}, {"difference", values}}, values, "",
                options);
}

Status RunScore(const ScoreOptions& options) {
  const int tests = (options.image.empty() ? 0 : 1) +
                    (options.ansi.empty() ? 0 : 1) +
                    (options.cells.empty() ? 0 : 1);
  const bool grids = !options.against.empty() && !options.cells.empty();
  if (grids && tests == 1 && options.reference.empty()) {
    if (!options.maps.empty()) {
      return Fail(BadInput("--maps",
                           "needs --reference: grids have no errors "
                           "but different cells"));
    }
    return CompareGrids(options);
  }
  if (tests == 1 && !options.reference.empty() && options.against.empty()) {
    return ScoreAgainstReference(options);
  }
  return Fail(BadInput("score",
                       "expected --reference and one of --image, --ansi and "
                       "--cells, or --cells and --against"));
}

void AddOptions(CLI::App& app, ScoreOptions& options) {
  AddText(app, {"--reference", "IMAGE", "", "What the test should look like"},
          options.reference);
  AddText(app, {"--image", "IMAGE", "", "Test: an image"}, options.image);
  AddText(app, {"--ansi", "FILE|-", "", "Test: ANSI text; needs --grid"},
          options.ansi);
  AddText(app, {"--cells", "FILE|-", "", "Test: cells as JSON"}, options.cells);
  AddText(app,
          {"--against", "FILE|-", "",
           "Cells as JSON that --cells is compared with, cell by cell"},
          options.against);
  AddGrid(app, options.grid, "");
  AddExposure(app, options.exposure, "0");
  AddDecodeOptions(app, options.decode);
  AddThreads(app, options.threads);
  AddText(app,
          {"--maps", "DIR", "",
           "Write flip.png (FLIP at 40 pixels per degree, in magma) and "
           "difference.png (absolute, per channel)"},
          options.maps);
  AddJson(app, options.json);
}

}  // namespace

void AddScore(CLI::App& program, Action& selected) {
  AddCommand<ScoreOptions>(program, selected, "score",
                           "Scores an image or cells against a reference",
                           AddOptions, RunScore);
}

}  // namespace rtb
