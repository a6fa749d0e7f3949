/// @file
/// The meaning of complete escape sequences that terminals send.
#pragma once

#include <optional>

#include "encoders/parse/ansi_token.h"
#include "harness/live/input_event.h"

namespace rtb {

/// The event of a CSI or string; none for what means nothing here.
/// Sources: xterm's ctlseqs; kitty's "Comprehensive keyboard handling in
/// terminals".
std::optional<InputEvent> EventOf(const AnsiToken& token);

/// A key without ESC before it: a character, or a control byte.
KeyEvent PlainKey(char32_t code);

/// The key of SS3 (ESC O) and this byte; none for others.
std::optional<KeyEvent> Ss3Key(char final);

}  // namespace rtb
