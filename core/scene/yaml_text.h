/// @file
/// Checks of a text before YAML is read from it.
#pragma once

#include <string>

#include "core/base/result.h"

namespace rtb {

/// Success when `text` is UTF-8 of acceptable size without control characters
/// (tab, line feed and carriage return aside).
/// @param file names the text in errors.
Status CheckYamlText(const std::string& text, const std::string& file);

}  // namespace rtb
