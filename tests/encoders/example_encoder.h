/// @file
/// The example of docs/adding-an-encoder.md.
#pragma once

#include "encoders/registry.h"

namespace rtb {

EncoderEntry example_entry();

}  // namespace rtb
