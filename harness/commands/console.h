/// @file
/// The console: results on standard output, all else on standard error.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "harness/results/run_record_json.h"

namespace rtb {

/// Call first: writing to a closed pipe becomes an Error instead of a signal,
/// and a descriptor that the caller closed cannot become one of our files.
void PrepareConsole();

/// `rtbench: <error>` on standard error, in red on a terminal unless NO_COLOR
/// is set.
void PrintError(const Error& error);

/// `rtbench: <text>` on standard error.
void PrintNote(const std::string& text);

/// Bytes to a file (atomically), or to standard output for `-`.
/// @return kFailure when they cannot all be written.
Status WriteOutput(const std::string& target, std::string_view bytes);

/// JSON, indented by two, with a line's end; broken UTF-8 is replaced.
Status WriteJson(const std::string& target, const Json& json);

/// Bytes to standard error, as they are: for a preview beside JSON.
void WriteToStderr(std::string_view bytes);

/// Everything on standard input.
Result<std::string> ReadStandardInput();

/// Whether standard output is a terminal.
bool OutputIsTerminal();

/// Whether NO_COLOR asks for output without colors (no-color.org: set and not
/// empty).
bool ColorsUnwanted();

/// The command line of this process.
std::vector<std::string> CommandLine();

/// Shows the share of a long job in percent on standard error: a line that is
/// rewritten in place on a terminal, one line every ten seconds elsewhere.
/// Prints nothing when `quiet`.
std::function<void(double share, const std::string& what)> ProgressLine(
    bool quiet);

/// The same as a bar with the time that is left, as far as the share tells.
std::function<void(double share, const std::string& what)> ProgressBar(
    bool quiet);

}  // namespace rtb
