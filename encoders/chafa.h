/// @file
/// libchafa, for the encoder of that name: the one place that may lack the
/// library. chafa_library.cc is compiled where it was found, else
/// chafa_missing.cc.
#pragma once

#include <memory>
#include <string>

#include "core/base/result.h"
#include "encoders/encoder.h"

namespace rtb {

/// How chafa is to choose; its program's options of the same names.
struct ChafaOptions {
  std::string symbols;  ///< Classes of characters, in its program's syntax.
  int work = 9;         ///< 1 (fast) to 9 (exact).
  bool median = false;  ///< Colors are medians instead of means.
  bool din99d = false;  ///< Compares colors in DIN99d instead of RGB.
};

/// The encoder.
/// @return kBadInput when chafa does not know the symbols, kMissing when this
///   program was built without the library.
Result<std::unique_ptr<Encoder>> MakeChafa(const ChafaOptions& options);

/// The version of the library that is loaded; empty without one.
std::string ChafaVersion();

}  // namespace rtb
