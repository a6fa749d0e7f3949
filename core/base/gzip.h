/// @file
/// Compression by gzip (RFC 1952), through zlib.
#pragma once

#include <string>
#include <string_view>

namespace rtb {

/// The bytes as a gzip file without a name or a time: equal bytes give equal
/// files.
std::string Gzip(std::string_view bytes);

}  // namespace rtb
