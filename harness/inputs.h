/// @file
/// The files that a record's figures depend on, with their hashes.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/scene/scene.h"
#include "encoders/decode.h"
#include "harness/results/run_record.h"

namespace rtb {

/// A file with its hash.
/// @return an Error when it cannot be read.
Result<InputFile> HashedInput(const std::string& role,
                              const std::filesystem::path& file);

/// The scene's file (`scene`) and, each once, those that it names: `mesh` and
/// `image`.
Result<std::vector<InputFile>> SceneInputs(const Scene& scene);

/// The fonts (`font`) that decoding these glyphs opens, in the order of
/// FontChain; none where all have exact shapes.
Result<std::vector<InputFile>> FontInputs(const std::set<char32_t>& glyphs,
                                          const DecodeOptions& options);

/// Success when the font of the options, if they name one, can be used: to be
/// asked before long work.
Status CheckFont(const DecodeOptions& options);

}  // namespace rtb
