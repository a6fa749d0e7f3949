#include "harness/commands/program.h"

#include <algorithm>
#include <exception>
#include <new>
#include <string>
#include <vector>

#include "core/base/manifest.h"
#include "core/base/suggest.h"
#include "harness/commands/command.h"
#include "harness/commands/console.h"

namespace rtb {
namespace {

std::vector<std::string> CommandNames(const CLI::App& program) {
  std::vector<std::string> names;
  for (const CLI::App* command : program.get_subcommands({})) {
    names.push_back(command->get_name());
  }
  return names;
}

void AddCommands(CLI::App& program, Action& selected) {
  program.name("rtbench");
  program.set_help_flag("-h,--help", "Print this help and exit");
  program.set_version_flag("--version", [] {
    const BuildInfo build = GetBuildInfo();
    return "rtbench " + build.version + " (" + build.commit +
           (build.dirty ? ", changed" : "") + ")";
  });
  program.require_subcommand(1);
  AddBench(program, selected);
  AddRender(program, selected);
  AddEncode(program, selected);
  AddScore(program, selected);
  AddSweep(program, selected);
  AddReference(program, selected);
  AddExport(program, selected);
  AddReport(program, selected);
  AddLive(program, selected);
  AddList(program, selected);
  program.footer(
      "Without a command, bench is run: rtbench --scene=cornell\n"
      "rtbench COMMAND --help lists a command's options.\n"
      "Exit status: 0 success, 1 failure, 2 usage or bad input, 3 missing "
      "device or tool");
}

/// The arguments with the default command in front where none is named.
Result<std::vector<std::string>> WithCommand(const CLI::App& program,
                                             std::vector<std::string> args) {
  const std::string first = args.empty() ? "" : args.front();
  if (first == "-h" || first == "--help" || first == "--version") return args;
  if (first.empty() || first.front() == '-') {
    args.insert(args.begin(), "bench");
    return args;
  }
  const std::vector<std::string> names = CommandNames(program);
  if (std::find(names.begin(), names.end(), first) != names.end()) return args;
  return Fail(BadInput(
      "",
      "unknown command '" + first + "', expected one of " + JoinNames(names),
      DidYouMean(first, names)));
}

/// Parses; help and version are Actions too.
Result<Action> Parse(CLI::App& program, Action& selected,
                     std::vector<std::string> args) {
  try {
    std::reverse(args.begin(), args.end());  // CLI11 takes them last first.
    program.parse(args);
  } catch (const CLI::CallForHelp&) {
    const auto chosen = program.get_subcommands();
    const std::string text = chosen.empty()
                                 ? program.help()
                                 : chosen.front()->help(program.get_name());
    return [text] { return WriteOutput("-", text); };
  } catch (const CLI::CallForVersion& version) {
    return [text = std::string(version.what()) + "\n"] {
      return WriteOutput("-", text);
    };
  } catch (const CLI::ParseError& error) {
    return Fail(BadInput("", error.what(), "see --help"));
  }
  return selected;
}

Status Run(int argc, char** argv) {
  CLI::App program(
      "Draws ray-traced scenes with Unicode cells, scores and "
      "times how");
  Action selected;
  AddCommands(program, selected);
  RTB_ASSIGN_OR_RETURN(std::vector<std::string> args,
                       WithCommand(program, {argv + 1, argv + argc}));
  RTB_ASSIGN_OR_RETURN(const Action action,
                       Parse(program, selected, std::move(args)));
  return action();
}

}  // namespace

int RunProgram(int argc, char** argv) {
  PrepareConsole();
  Status status;
  try {
    status = Run(argc, argv);
  } catch (const std::bad_alloc&) {
    status = Fail(Failure("", "out of memory", "take a smaller grid or size"));
  } catch (const std::exception& error) {
    status = Fail(Failure("", error.what()));
  }
  if (status) return 0;
  PrintError(status.error());
  return static_cast<int>(status.error().kind);
}

}  // namespace rtb
