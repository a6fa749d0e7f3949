/// @file
/// What a terminal driver does to a program's output before the terminal
/// sees it.
#pragma once

#include <string>
#include <string_view>

namespace rtb {

/// `output` with LF as CR LF, as a tty writes it; and without the LFs after
/// the last visible character (color, mode and cursor visibility sequences
/// may follow it): a picture as high as the terminal would otherwise scroll
/// its first row away.
std::string TerminalInput(std::string_view output);

}  // namespace rtb
