#include "encoders/modifiers/temporal.h"

#include <algorithm>
#include <cmath>

namespace rtb {
namespace {

/// sigma^2 (degrees + z sqrt(spread)) + 2 z sigma sqrt(best).
double Margin(const StabilityTest& test, double best, double degrees,
              double spread) {
  return test.sigma * test.sigma * (degrees + test.z * std::sqrt(spread)) +
         2 * test.z * test.sigma * std::sqrt(best);
}

double MaskDegrees(const StabilityTest& test) {
  return 2 * std::log2(std::max(test.partitions, 1.0));
}

}  // namespace

double StabilityTest::CellMargin(double best) const {
  const double degrees = 12 + MaskDegrees(*this);
  return Margin(*this, best, degrees, 2 * degrees + 24);
}

double StabilityTest::MaskMargin(double best) const {
  const double degrees = MaskDegrees(*this);
  return Margin(*this, best, degrees, 2 * degrees);
}

}  // namespace rtb
