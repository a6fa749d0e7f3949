#include "encoders/adaptive/wide_mean.h"

#include <algorithm>
#include <vector>

#include "core/color/srgb.h"

namespace rtb {

void BlendWide(const NearSamples& near, const BlendPlaces& places,
               std::span<Rgb> out) {
  const std::size_t count = out.size();
  std::vector<float> sum(count), weights(count);
  std::vector<Rgb> linear(count, Rgb(0));
  std::fill(out.begin(), out.end(), Rgb(0));
  for (std::size_t n = 0; n < near.size(); ++n) {
    for (std::size_t i = 0; i < count; ++i) {
      weights[i] = WideWeight(places.x[i] - near.x[n], places.y[i] - near.y[n]);
    }
    for (std::size_t i = 0; i < count; ++i) {
      sum[i] += weights[i];
      out[i] += near.encoded[n] * weights[i];
      linear[i] += near.linear[n] * weights[i];
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    out[i] /= sum[i];
    linear[i] /= sum[i];
  }
  SrgbEncode(linear, linear);
  for (std::size_t i = 0; i < count; ++i) out[i] = (out[i] + linear[i]) * 0.5f;
}

}  // namespace rtb
