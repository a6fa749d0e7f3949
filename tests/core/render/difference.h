// How the images of two backends differ.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "core/math/vec.h"

namespace rtb::testing {

/// How two images differ, by the largest channel of each pixel.
struct Difference {
  Difference(const std::vector<Rgb>& a, const std::vector<Rgb>& b) {
    std::vector<float> all;
    double squares = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
      const Rgb d = a[i] - b[i];
      all.push_back(std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)}));
      if (all.back() > 1e-3f) {
        ++off;
      } else {
        squares += d.length2() / 3;
      }
    }
    const auto middle = all.begin() + static_cast<std::ptrdiff_t>(a.size() / 2);
    std::nth_element(all.begin(), middle, all.end());
    median = *middle;
    rmse = std::sqrt(squares / static_cast<double>(a.size()));
  }

  int off = 0;  ///< Pixels by more than 1e-3.
  double median = 0;
  double rmse = 0;  ///< Of the other pixels.
};

}  // namespace rtb::testing
