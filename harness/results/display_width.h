/// @file
/// How many terminal columns a text takes.
#pragma once

#include <string_view>

namespace rtb {

/// Columns of UTF-8 text: 1 a code point, 2 for East Asian wide characters and
/// emoji (Unicode Standard Annex 11), 0 for combining marks and joiners. A byte
/// that is no UTF-8 counts as one column.
int DisplayWidth(std::string_view utf8);

}  // namespace rtb
