#include "harness/metrics/structure.h"

#include <functional>

#include "core/base/check.h"
#include "harness/metrics/convolve.h"
#include "harness/metrics/rows.h"

namespace rtb {
namespace {

// Wang, Bovik, Sheikh and Simoncelli, "Image Quality Assessment: From Error
// Visibility to Structural Similarity", IEEE TIP 13(4), 2004, section III.
constexpr double kSigma = 1.5;
constexpr double kC1 = 0.01 * 0.01;
constexpr double kC2 = 0.03 * 0.03;

ChannelPlane Product(const ChannelPlane& a, const ChannelPlane& b,
                     int threads) {
  return CombinePlanes(a, b, threads, std::multiplies<>());
}

/// Local moments under the Gaussian window.
struct Moments {
  ChannelPlane a, b, aa, bb, ab;
};

Moments LocalMoments(const ChannelPlane& a, const ChannelPlane& b,
                     int threads) {
  const Kernel window = GaussianKernel(kSigma, kSsimWindow / 2);
  const auto blur = [&](const ChannelPlane& in) {
    return Filter(in, window, threads);
  };
  return {blur(a), blur(b), blur(Product(a, a, threads)),
          blur(Product(b, b, threads)), blur(Product(a, b, threads))};
}

Structure At(const Moments& m, int x, int y) {
  const double a = m.a.row(y)[x];
  const double b = m.b.row(y)[x];
  const double variance_a = m.aa.row(y)[x] - a * a;
  const double variance_b = m.bb.row(y)[x] - b * b;
  const double covariance = m.ab.row(y)[x] - a * b;
  const double luminance = (2 * a * b + kC1) / (a * a + b * b + kC1);
  const double contrast =
      (2 * covariance + kC2) / (variance_a + variance_b + kC2);
  return {luminance * contrast, contrast};
}

}  // namespace

Structure CompareStructure(const ChannelPlane& a, const ChannelPlane& b,
                           int threads) {
  RTB_CHECK_GE(a.width(), kSsimWindow);
  RTB_CHECK_GE(a.height(), kSsimWindow);
  const Moments moments = LocalMoments(a, b, threads);
  // The filters replicate borders; where the window lies inside, they do not
  // matter, and nothing else is used.
  constexpr int kBorder = kSsimWindow / 2;
  const int width = a.width() - 2 * kBorder;
  const int height = a.height() - 2 * kBorder;
  const auto mean = [&](double Structure::*part) {
    return MeanOverPixels(width, height, threads, [&](int x, int y) {
      return At(moments, x + kBorder, y + kBorder).*part;
    });
  };
  return {mean(&Structure::similarity), mean(&Structure::contrast)};
}

}  // namespace rtb
