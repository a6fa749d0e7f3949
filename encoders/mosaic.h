/// @file
/// Mosaic: encoders that split a cell's 2 x N samples into two colors in the
/// best way there is.
#pragma once

#include "encoders/registry.h"

namespace rtb {

/// How one mosaic differs from another.
struct MosaicKind {
  int rows;                     ///< Of samples; there are 2 columns.
  char32_t (*glyph)(unsigned);  ///< For a pattern (glyphs/patterns.h).
  /// What fills all of the pattern's sub-cells, where `glyph` does not.
  char32_t (*filling)(unsigned) = nullptr;
};

/// Makes an encoder that takes, of all two-way partitions of the samples, the
/// one of least squared error. The only parameter is `blend`.
Result<std::unique_ptr<Encoder>> MakeMosaic(const MosaicKind& kind,
                                            const EncoderParameters& given);

}  // namespace rtb
