#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

#include "core/base/process.h"
#include "core/base/suggest.h"
#include "harness/commands/command.h"
#include "harness/commands/console.h"
#include "harness/commands/options.h"
#include "harness/lookup.h"

namespace rtb {
namespace {

namespace fs = std::filesystem;

constexpr char kFormats[] = "latex,csv,markdown,html,plots";

struct ReportOptions {
  std::string folder;
  std::string out;
  std::string formats = kFormats;
  bool quiet = false;
};

std::vector<std::string> SplitAtCommas(const std::string& text) {
  std::vector<std::string> parts(1);
  for (const char letter : text) {
    if (letter == ',') {
      parts.emplace_back();
    } else {
      parts.back() += letter;
    }
  }
  return parts;
}

Status CheckFormats(const std::string& formats) {
  const std::vector<std::string> known = SplitAtCommas(kFormats);
  for (const std::string& format : SplitAtCommas(formats)) {
    if (std::find(known.begin(), known.end(), format) == known.end()) {
      return Fail(BadInput(
          "--format",
          "found '" + format + "', expected some of " + JoinNames(known),
          DidYouMean(format, known)));
    }
  }
  return {};
}

/// The Python package that makes reports, beside the program's other data.
Result<fs::path> FindReporter() {
  for (const fs::path& folder : FindDataFolders()) {
    const fs::path found = folder / "scripts" / "report";
    std::error_code ignored;
    if (fs::exists(found / "__main__.py", ignored)) return found;
  }
  return Fail(Missing("report", "its folder scripts/report was not found",
                      "set RTBENCH_DATA to the repository or to an "
                      "installation's share/rtbench"));
}

/// The Python to run it with: RTBENCH_PYTHON, python3 on PATH, Debian's.
std::string FindPython() {
  const char* chosen = std::getenv("RTBENCH_PYTHON");
  if (chosen != nullptr && *chosen != '\0') return chosen;
  return FindProgram("python3") ? "python3" : "/usr/bin/python3";
}

/// Python's exit status and words as one of our errors.
Status StatusOf(const ProcessResult& process) {
  if (process.exit_status == 0) return {};
  std::string what = process.err;
  while (!what.empty() && what.back() == '\n') what.pop_back();
  // A traceback is a defect of ours; its last line says what happened.
  what = what.substr(what.rfind('\n') + 1);
  if (process.exit_status == 2) return Fail(BadInput("report", what));
  if (process.exit_status == 3) return Fail(Missing("report", what));
  return Fail(Failure("report", what));
}

Status Report(const ReportOptions& options) {
  std::error_code ignored;
  if (!fs::is_directory(options.folder, ignored)) {
    return Fail(BadInput(
        "DIR", "found '" + options.folder + "', expected a folder of records",
        "rtbench sweep SUITE.yaml --out=DIR writes one"));
  }
  RTB_RETURN_IF_ERROR(CheckFormats(options.formats));
  RTB_ASSIGN_OR_RETURN(const fs::path reporter, FindReporter());
  // -B: an installed folder may not be ours to write into.
  ProcessOptions process;
  process.argv = {FindPython(),
                  "-B",
                  reporter.string(),
                  "--out=" + options.out,
                  "--format=" + options.formats,
                  "--",
                  options.folder};
  RTB_ASSIGN_OR_RETURN(const ProcessResult result, RunProcess(process));
  RTB_RETURN_IF_ERROR(StatusOf(result));
  if (options.quiet) return {};
  WriteToStderr(result.err);
  return WriteOutput("-", result.out);
}

void AddOptions(CLI::App& app, ReportOptions& options) {
  app.add_option("DIR", options.folder,
                 "What rtbench sweep wrote, or records of the main job")
      ->required();
  AddText(app, {"--out", "DIR", "", "Where the report is written"}, options.out)
      ->required();
  AddText(app,
          {"--format", "LIST", kFormats,
           "Some of these: tables, all figures, a page, plots"},
          options.formats);
  AddQuiet(app, options.quiet);
}

}  // namespace

void AddReport(CLI::App& program, Action& selected) {
  AddCommand<ReportOptions>(program, selected, "report",
                            "Makes tables, plots and a page of a sweep's "
                            "records",
                            AddOptions, Report);
}

}  // namespace rtb
