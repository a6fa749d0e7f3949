#include "harness/bench.h"

#include <filesystem>
#include <set>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "core/base/file.h"
#include "core/image/io.h"
#include "encoders/emit/emit.h"
#include "harness/commands/command.h"
#include "harness/commands/console.h"
#include "harness/commands/options.h"
#include "harness/measure/cache.h"
#include "harness/results/run_record_json.h"
#include "harness/results/run_table.h"

namespace rtb {
namespace {

struct BenchOptions {
  BenchRequest request;
  std::string json;
  std::string out;
  bool preview = false;
  bool quiet = false;
};

/// The glyphs alone.
std::string PlainText(const CellGrid& grid) {
  std::string text;
  for (int row = 0; row < grid.size.rows; ++row) {
    for (int column = 0; column < grid.size.columns; ++column) {
      text += Utf8(grid.at(column, row).glyph);
    }
    text += "\n";
  }
  return text;
}

std::string Preview(const BenchResult& result, ColorDepth depth) {
  std::string text;
  for (const BenchPicture& picture : result.pictures) {
    text += Printable(picture.encoder) + "\n" +
            (ColorsUnwanted() ? PlainText(picture.grid)
                              : EmitAnsi(picture.grid, depth));
  }
  return text;
}

/// A file name for a SPEC that `used` does not hold yet.
std::string FileName(const std::string& spec, std::set<std::string>& used) {
  constexpr std::size_t kLongest = 100;
  std::string name = spec.substr(0, kLongest);
  for (char& c : name) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                       (c >= '0' && c <= '9') || c == '-' || c == '.';
    if (!plain) c = '_';
  }
  std::string unique = name;
  for (int i = 2; !used.insert(unique).second; ++i) {
    unique = name + "_" + std::to_string(i);
  }
  return unique;
}

/// Makes the folder before the work is done, so that its errors come first.
Status MakeFolder(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (!error) return {};
  return Fail(Failure(folder, "cannot be made: " + error.message()));
}

/// Record, grids and pictures.
Status WriteFolder(const std::filesystem::path& folder,
                   const BenchResult& result, ColorDepth depth) {
  RTB_RETURN_IF_ERROR(
      WriteFileAtomically(folder / "record.json", FormatRecord(result.record)));
  RTB_RETURN_IF_ERROR(WritePng(folder / "reference.png", result.reference));
  std::set<std::string> used{"record", "reference"};
  for (const BenchPicture& picture : result.pictures) {
    const std::string name = FileName(picture.encoder, used);
    RTB_RETURN_IF_ERROR(
        WriteFileAtomically(folder / (name + ".json"), EmitJson(picture.grid)));
    RTB_RETURN_IF_ERROR(WriteFileAtomically(folder / (name + ".ansi"),
                                            EmitAnsi(picture.grid, depth)));
    RTB_RETURN_IF_ERROR(WritePng(folder / (name + ".png"), picture.decoded));
  }
  return {};
}

/// To be taken before the work.
RunConditions Conditions(const BenchOptions& options) {
  return {UtcNow(), CommandLine(), options.request.scene.options.threads,
          GetHostInfo()};
}

Status Print(const BenchOptions& options, const BenchResult& result) {
  const bool json_alone = options.json == "-";
  if (options.preview && json_alone)
    WriteToStderr(Preview(result, options.request.depth));
  if (json_alone) return WriteOutput("-", FormatRecord(result.record));
  std::string text = FormatRunTable(result.record.runs);
  if (options.preview) text += Preview(result, options.request.depth);
  return WriteOutput("-", text);
}

Status RunBench(const BenchOptions& options) {
  if (!options.out.empty()) RTB_RETURN_IF_ERROR(MakeFolder(options.out));
  RunConditions conditions = Conditions(options);
  BenchRequest request = options.request;
  if (request.decompose) request.cache = CacheFolder();
  RTB_ASSIGN_OR_RETURN(BenchResult result,
                       Bench(request, ProgressLine(options.quiet)));
  RunRecord& record = result.record;
  record.conditions = std::move(conditions);
  if (!options.quiet) {
    for (const std::string& note : result.notes) PrintNote(note);
  }
  if (!options.out.empty()) {
    RTB_RETURN_IF_ERROR(
        WriteFolder(options.out, result, options.request.depth));
  }
  if (!options.json.empty() && options.json != "-") {
    RTB_RETURN_IF_ERROR(
        WriteFileAtomically(options.json, FormatRecord(record)));
  }
  return Print(options, result);
}

void AddOptions(CLI::App& app, BenchOptions& options) {
  AddSceneOptions(app, options.request.scene);
  AddText(app,
          {"--encoder", "SPEC[,SPEC...]|all", options.request.encoders,
           "name[:key=value...]; see `list encoders`"},
          options.request.encoders);
  AddGrid(app, options.request.grid, "120x40");
  AddColorDepth(app, options.request.depth);
  AddDecodeOptions(app, options.request.decode);
  AddText(app,
          {"--reference", "povray|cycles|self|FILE", "the first that there is",
           "What is compared with; self is our own converged image"},
          options.request.reference);
  AddInteger(app, {"--repeat", "N", "10", "Timed runs of each encoder"},
             options.request.repeat, 1, 100000);
  app.add_flag(
      "--decompose", options.request.decompose,
      "Say where errors come from: rendering, sampling, encoding, glyphs");
  AddJson(app, options.json);
  AddText(app, {"--out", "DIR", "", "Write record, grids and pictures"},
          options.out);
  app.add_flag("--preview", options.preview, "Print what was drawn");
  AddQuiet(app, options.quiet);
}

}  // namespace

void AddBench(CLI::App& program, Action& selected) {
  AddCommand<BenchOptions>(
      program, selected, "bench",
      "Renders, encodes, scores and times (the default command)", AddOptions,
      RunBench);
}

}  // namespace rtb
