// Encoder `sextant`: 2 x 3 samples in the two colors that fit them best, drawn
// with the sextants of Unicode 13.
#include "encoders/blend.h"
#include "encoders/glyphs/patterns.h"
#include "encoders/mosaic.h"

namespace rtb {
namespace {

Result<std::unique_ptr<Encoder>> Make(const EncoderParameters& given) {
  return MakeMosaic({3, SextantGlyph}, given);
}

}  // namespace

EncoderEntry sextant_entry() {
  return {{"sextant",
           "the best two-way partition of 2 x 3 samples",
           6,
           "space, U+258C, U+2590, U+1FB00-1FB3B",
           {BlendParameter()}},
          Make};
}

}  // namespace rtb
