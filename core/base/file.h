/// @file
/// Whole files: reading, and writing so that nobody ever sees half of one.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace rtb {

/// The bytes of a file, at most `limit` of them (more is an Error).
Result<std::string> ReadFile(const std::filesystem::path& file,
                             std::size_t limit = SIZE_MAX);

/// Writes beside the target, syncs, and renames over it: after a crash the
/// file is the old one or the new one, never a mixture. Creates parent
/// directories. Keeps the mode of a file that exists; writes through to
/// devices and pipes such as /dev/stdout.
Status WriteFileAtomically(const std::filesystem::path& file,
                           std::string_view bytes);

/// SHA-256 in lowercase hexadecimal (through OpenSSL).
std::string Sha256(std::string_view bytes);
/// SHA-256 of a file's bytes.
Result<std::string> Sha256File(const std::filesystem::path& file);

}  // namespace rtb
