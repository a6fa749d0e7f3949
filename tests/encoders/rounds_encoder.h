/// @file
/// An encoder that asks in rounds, as docs/adding-an-encoder.md shows it.
#pragma once

#include "encoders/registry.h"

namespace rtb {

EncoderEntry rounds_entry();

}  // namespace rtb
