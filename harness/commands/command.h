/// @file
/// The subcommands: each adds its options to the parser and says what to do.
/// Only the files of this folder print.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

#include "core/base/result.h"

namespace rtb {

/// What the parsed command line asks for; an Error becomes the exit status.
using Action = std::function<Status()>;

/// @name One a file of this folder. Parsing the subcommand sets `selected`.
/// @{
void AddBench(CLI::App& program, Action& selected);
void AddRender(CLI::App& program, Action& selected);
void AddEncode(CLI::App& program, Action& selected);
void AddScore(CLI::App& program, Action& selected);
void AddSweep(CLI::App& program, Action& selected);
void AddReference(CLI::App& program, Action& selected);
void AddExport(CLI::App& program, Action& selected);
void AddReport(CLI::App& program, Action& selected);
void AddLive(CLI::App& program, Action& selected);
void AddList(CLI::App& program, Action& selected);
/// @}

/// Adds a subcommand that runs `run` on options of type T. `add_options`
/// binds the options; the memory lives as long as the parser.
template <class T>
void AddCommand(CLI::App& program, Action& selected, const char* name,
                const char* description, void (*add_options)(CLI::App&, T&),
                Status (*run)(const T&)) {
  auto options = std::make_shared<T>();
  CLI::App& command = *program.add_subcommand(name, description);
  add_options(command, *options);
  command.callback(
      [options, run, &selected] { selected = [=] { return run(*options); }; });
}

}  // namespace rtb
