#include "encoders/registry.h"

namespace rtb {

// Each plug-in's file defines the function that describes it.
#define RTB_ENCODER(name) EncoderEntry name##_entry();
#include "encoders/encoders.inc"
#undef RTB_ENCODER

std::span<const EncoderEntry> EncoderEntries() {
  static const std::vector<EncoderEntry> entries = {
#define RTB_ENCODER(name) name##_entry(),
#include "encoders/encoders.inc"
#undef RTB_ENCODER
  };
  return entries;
}

}  // namespace rtb
