#include "encoders/steps.h"

#include <algorithm>
#include <cmath>

#include "core/base/check.h"
#include "core/color/srgb.h"

namespace rtb {

std::int32_t EncodedSteps(float linear) {
  return static_cast<std::int32_t>(
      std::nearbyint(SrgbEncode(linear) * static_cast<float>(kWhiteSteps)));
}

void EncodedSteps(std::span<const Rgb> linear, std::span<StepColor> steps) {
  RTB_CHECK_EQ(linear.size(), steps.size());
  std::ranges::transform(linear, steps.begin(), [](const Rgb& color) {
    return StepColor(EncodedSteps(color.x), EncodedSteps(color.y),
                     EncodedSteps(color.z));
  });
}

}  // namespace rtb
