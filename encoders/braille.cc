// Encoder `braille`: 2 x 4 samples in the two colors that fit them best, drawn
// with braille dots.
#include "encoders/blend.h"
#include "encoders/glyphs/patterns.h"
#include "encoders/mosaic.h"

namespace rtb {
namespace {

Result<std::unique_ptr<Encoder>> Make(const EncoderParameters& given) {
  return MakeMosaic({4, BrailleGlyph, OctantGlyph}, given);
}

}  // namespace

EncoderEntry braille_entry() {
  return {{"braille",
           "the best two-way partition of 2 x 4 samples, as dots",
           8,
           "U+2800-28FF",
           {BlendParameter()}},
          Make};
}

}  // namespace rtb
