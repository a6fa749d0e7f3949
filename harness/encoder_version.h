/// @file
/// Which version of a library or of another program chooses the cells.
#pragma once

#include <string>

#include "encoders/registry.h"

namespace rtb {

/// The version behind a SPEC: of the library that chooses; of another program
/// its name, what it answers to `--version`, and how its file's SHA-256
/// begins: `chafa 1.12.4 (0123456789abcdef)`. Empty where this program chooses,
/// and for a program that is not there. Asked once for each program.
std::string EncoderVersion(const EncoderSpec& spec);

}  // namespace rtb
