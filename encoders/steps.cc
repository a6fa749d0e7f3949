#include "encoders/steps.h"

#include <algorithm>

#include "core/base/check.h"

namespace rtb {

std::int32_t EncodedSteps(float linear) {
  return EncodedStepsBy(SrgbCurve(), linear);
}

void EncodedSteps(std::span<const Rgb> linear, std::span<StepColor> steps) {
  RTB_CHECK_EQ(linear.size(), steps.size());
  std::ranges::transform(linear, steps.begin(), [](const Rgb& color) {
    return StepColor(EncodedSteps(color.x), EncodedSteps(color.y),
                     EncodedSteps(color.z));
  });
}

}  // namespace rtb
