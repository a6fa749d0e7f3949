/// @file
/// The program: parses the command line, runs a subcommand, reports.
#pragma once

namespace rtb {

/// Runs the program.
/// @return the exit status: 0 success, 1 failure, 2 usage or bad input,
/// 3 missing device or tool.
int RunProgram(int argc, char** argv);

}  // namespace rtb
