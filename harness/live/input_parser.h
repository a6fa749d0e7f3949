/// @file
/// InputParser: bytes from a terminal to events. Knows legacy keys (xterm's
/// ctlseqs), kitty's keyboard protocol, the SGR mouse, and answers to the
/// probe; reads may end anywhere.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "harness/live/input_event.h"

namespace rtb {

/// One for each terminal.
class InputParser {
 public:
  /// The events that these bytes complete, in order. What is no known
  /// sequence is left out.
  std::vector<InputEvent> Feed(std::string_view bytes);

  /// Whether the beginning of a sequence waits for its end.
  bool pending() const { return !buffer_.empty(); }

  /// The terminal has been silent for a while: a lone ESC is the Escape key,
  /// any other beginning is dropped.
  std::vector<InputEvent> Flush();

 private:
  /// Takes one piece off the buffer. @return false when more must come.
  bool Step(std::vector<InputEvent>* events);
  bool StepEscape(std::vector<InputEvent>* events);
  bool StepText(std::vector<InputEvent>* events);

  std::string buffer_;
};

}  // namespace rtb
