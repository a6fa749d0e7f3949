// Encoder `octant`: 2 x 4 samples in the two colors that fit them best, drawn
// with the octants of Unicode 16.
#include "encoders/blend.h"
#include "encoders/glyphs/patterns.h"
#include "encoders/mosaic.h"

namespace rtb {
namespace {

Result<std::unique_ptr<Encoder>> Make(const EncoderParameters& given) {
  return MakeMosaic({4, OctantGlyph}, given);
}

}  // namespace

EncoderEntry octant_entry() {
  return {{"octant",
           "the best two-way partition of 2 x 4 samples",
           8,
           "space, U+1CD00-1CDE5 and the older blocks among the octants",
           {BlendParameter()}},
          Make};
}

}  // namespace rtb
