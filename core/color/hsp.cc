#include "core/color/hsp.h"

#include <cmath>

namespace rtb {

double HspBrightness(const V3d& encoded) {
  return std::sqrt(0.299 * encoded.x * encoded.x +
                   0.587 * encoded.y * encoded.y +
                   0.114 * encoded.z * encoded.z);
}

}  // namespace rtb
