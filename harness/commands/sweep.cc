#include "harness/sweep/sweep.h"

#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <string>

#include "harness/commands/command.h"
#include "harness/commands/console.h"
#include "harness/commands/options.h"
#include "harness/results/table.h"

namespace rtb {
namespace {

struct SweepOptions {
  SweepRequest request;
  std::string suite;
  std::string out;
  bool dry_run = false;
  bool quiet = false;
};

volatile std::sig_atomic_t caught_signal = 0;

/// Of a signal handler: what may be called there is little.
void RememberSignal(int signal) {
  constexpr char kText[] = "\nrtbench: ends after this unit\n";
  caught_signal = signal;
  const auto written = ::write(STDERR_FILENO, kText, sizeof kText - 1);
  static_cast<void>(written);
}

/// Remembers the first SIGINT or SIGTERM: the unit in work is finished. The
/// next one ends the program at once, which leaves nothing half-written.
void CatchSignals() {
  struct sigaction action {};
  action.sa_handler = RememberSignal;
  action.sa_flags = static_cast<int>(SA_RESTART | SA_RESETHAND);
  ::sigaction(SIGINT, &action, nullptr);
  ::sigaction(SIGTERM, &action, nullptr);
}

/// Ends the program as the signal would have: whoever started it can tell.
void EndBySignal(int signal) {
  std::signal(signal, SIG_DFL);
  static_cast<void>(std::raise(signal));
}

const char* NameOf(UnitState state) {
  switch (state) {
    case UnitState::kDone:
      return "done";
    case UnitState::kFailed:
      return "failed";
    case UnitState::kSkipped:
      return "skipped";
    case UnitState::kMissing:
      break;
  }
  return "to do";
}

/// One line a unit.
Status List(const SweepOptions& options, const SweepPlan& plan) {
  const SweepFolder folder = SweepFolder::Look(options.request.out);
  Table table{{{"state", false}, {"unit", false}, {"work", false}}, {}};
  for (const SweepUnit& unit : plan.units) {
    table.rows.push_back(
        {NameOf(folder.StateOf(unit)), unit.Name(), Describe(unit)});
  }
  return WriteOutput("-", FormatTable(table));
}

std::string Count(int count, const std::string& what) {
  return count == 0 ? "" : ", " + std::to_string(count) + " " + what;
}

std::string Sentence(const SweepSummary& summary) {
  return std::to_string(summary.done) + " units done" +
         Count(summary.present, "there already") +
         Count(summary.failed, "failed") +
         Count(summary.skipped, "skipped for want of what they need") +
         Count(summary.postponed,
               "timing units left: they run alone, without --jobs") +
         Count(summary.left, "not begun") + "\n";
}

Status Finish(const SweepOptions& options, const SweepSummary& summary) {
  RTB_RETURN_IF_ERROR(WriteOutput("-", Sentence(summary)));
  const std::string folder = options.request.out.string();
  if (caught_signal != 0 && summary.left > 0) {
    PrintError(Failure(folder, "interrupted", "--resume goes on"));
    EndBySignal(caught_signal);
  }
  if (summary.failed == 0) return {};
  return Fail(Failure(folder, std::to_string(summary.failed) + " units failed",
                      "their records say why; --resume tries them again"));
}

Status RunSweepCommand(const SweepOptions& given) {
  SweepOptions options = given;
  options.request.suite = given.suite;
  options.request.out = given.out;
  options.request.command = CommandLine();
  CatchSignals();
  RTB_ASSIGN_OR_RETURN(const SweepPlan plan, PlanSweep(options.request));
  if (options.dry_run) return List(options, plan);
  const auto progress = ProgressBar(options.quiet);
  const SweepObserver observer{
      progress,
      [quiet = options.quiet](const std::string& text) {
        if (!quiet) PrintNote(text);
      },
      [] { return caught_signal != 0; }};
  RTB_ASSIGN_OR_RETURN(const SweepSummary summary,
                       RunSweep(options.request, plan, observer));
  return Finish(options, summary);
}

Result<std::set<UnitKind>> ParseKinds(const std::string& place,
                                      const std::string& text) {
  std::set<UnitKind> kinds;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string word = text.substr(begin, end - begin);
    const auto kind = FindUnitKind(word);
    if (!kind) {
      return Fail(
          NotExpected(place, word, "quality, timing, temporal or live"));
    }
    kinds.insert(*kind);
    begin = end + 1;
  }
  return kinds;
}

void AddOptions(CLI::App& app, SweepOptions& options) {
  constexpr int kMaxJobs = 1024;
  app.add_option("suite", options.suite, "What to run, as YAML")
      ->required()
      ->type_name("SUITE");
  AddText(app,
          {"--out", "DIR", "", "Folder of the records, made where it is not"},
          options.out)
      ->required();
  SweepRequest& request = options.request;
  app.add_flag("--resume", request.resume,
               "Run what is missing in DIR, and what failed");
  AddInteger(app,
             {"--jobs", "N", "1",
              "Units at a time; with more than 1 no times are taken"},
             request.jobs, 1, kMaxJobs);
  AddParsed(app, {"--shard", "I/N", "0/1", "Run slice I (from 0) of N alone"},
            request.shard, ParseShard);
  AddParsed(app,
            {"--kinds", "KIND[,KIND...]", "all",
             "Of quality, temporal, timing and live"},
            request.kinds, ParseKinds);
  AddThreads(app, request.threads);
  app.add_flag("--dry-run", options.dry_run,
               "List the units and what is there of them, and end");
  AddQuiet(app, options.quiet);
}

}  // namespace

void AddSweep(CLI::App& program, Action& selected) {
  AddCommand<SweepOptions>(program, selected, "sweep",
                           "Runs all of a suite, resumably", AddOptions,
                           RunSweepCommand);
}

}  // namespace rtb
