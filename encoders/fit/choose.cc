#include "encoders/fit/choose.h"

namespace rtb {

std::vector<Prospect> Survey(const Atlas& atlas,
                             const CenteredSamples& samples) {
  std::vector<Prospect> prospects;
  prospects.reserve(atlas.candidates().size());
  for (const FitMask& mask : atlas.candidates()) {
    Prospect& prospect = prospects.emplace_back();
    if (mask.complement >= 0) continue;
    prospect.correlation = Correlate(mask, samples);
    prospect.least = LeastError(mask, samples, prospect.correlation);
  }
  return prospects;
}

}  // namespace rtb
