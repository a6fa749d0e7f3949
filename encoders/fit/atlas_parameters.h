/// @file
/// The parameters of encoders that choose from an Atlas.
#pragma once

#include <vector>

#include "encoders/fit/atlas.h"
#include "encoders/parameters.h"

namespace rtb {

/// `glyphs=`, `mask=` and `atlas=`, for EncoderInfo.
std::vector<EncoderParameter> AtlasParameters();

/// The atlas that they ask for.
/// @return kBadInput for values that are none, and the errors of MakeAtlas.
Result<Atlas> ReadAtlas(const EncoderParameters& given);

}  // namespace rtb
