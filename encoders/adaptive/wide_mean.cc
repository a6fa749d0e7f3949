#include "encoders/adaptive/wide_mean.h"

#include <array>
#include <vector>

#include "core/color/srgb.h"

namespace rtb {
namespace {

/// Weighted sums of one channel at every place.
using Sums = std::vector<float>;

// A loop of its own, which compilers turn into vectors.
void AddTo(Sums& sums, const Sums& weights, float value) {
  for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += weights[i] * value;
}

class WideSums {
 public:
  explicit WideSums(std::size_t places)
      : weights_(places),
        weight_(places),
        encoded_{weight_, weight_, weight_},
        linear_(encoded_) {}

  void Add(const NearSamples& near, std::size_t n, const BlendPlaces& places) {
    for (std::size_t i = 0; i < weights_.size(); ++i) {
      weights_[i] =
          WideWeight(places.x[i] - near.x[n], places.y[i] - near.y[n]);
    }
    AddTo(weight_, weights_, 1);
    for (std::size_t c = 0; c < encoded_.size(); ++c) {
      const int channel = static_cast<int>(c);
      AddTo(encoded_[c], weights_, near.encoded[n][channel]);
      AddTo(linear_[c], weights_, near.linear[n][channel]);
    }
  }

  Rgb Encoded(std::size_t place) const { return Mean(encoded_, place); }
  Rgb Linear(std::size_t place) const { return Mean(linear_, place); }

 private:
  Rgb Mean(const std::array<Sums, 3>& sums, std::size_t place) const {
    return Rgb(sums[0][place], sums[1][place], sums[2][place]) / weight_[place];
  }

  Sums weights_;  ///< Of the sample that is being added.
  Sums weight_;   ///< Of all.
  std::array<Sums, 3> encoded_;
  std::array<Sums, 3> linear_;
};

}  // namespace

void BlendWide(const NearSamples& near, const BlendPlaces& places,
               std::span<Rgb> out) {
  WideSums sums(out.size());
  for (std::size_t n = 0; n < near.size(); ++n) sums.Add(near, n, places);
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = sums.Linear(i);
  SrgbEncode(out, out);
  for (std::size_t i = 0; i < out.size(); ++i) {
    out[i] = (out[i] + sums.Encoded(i)) * 0.5f;
  }
}

}  // namespace rtb
