#include "harness/metrics/convolve.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "harness/metrics/rows.h"

namespace rtb {
namespace {

int Radius(const Kernel& kernel) { return static_cast<int>(kernel.size() / 2); }

/// out[x] += weight * in[x]. The loop over a whole row for one weight is what
/// compilers vectorize.
void AddScaled(double weight, const double* in, int count, double* out) {
  for (int x = 0; x < count; ++x) out[x] += weight * in[x];
}

}  // namespace

Kernel GaussianKernel(double sigma, int radius) {
  Kernel kernel;
  for (int x = -radius; x <= radius; ++x) {
    kernel.push_back(std::exp(-x * x / (2 * sigma * sigma)));
  }
  const double sum = std::accumulate(kernel.begin(), kernel.end(), 0.0);
  for (double& weight : kernel) weight /= sum;
  return kernel;
}

ChannelPlane FilterRows(const ChannelPlane& in, const Kernel& kernel,
                        int threads) {
  const int radius = Radius(kernel);
  const int width = in.width();
  ChannelPlane out(width, in.height());
  ForRows(in.height(), threads, [&](int y) {
    const double* row = in.row(y);
    std::vector<double> padded;
    padded.reserve(static_cast<std::size_t>(width + 2 * radius));
    padded.insert(padded.end(), static_cast<std::size_t>(radius), row[0]);
    padded.insert(padded.end(), row, row + width);
    padded.insert(padded.end(), static_cast<std::size_t>(radius),
                  row[width - 1]);
    const double* shifted = padded.data();
    for (const double weight : kernel) {
      AddScaled(weight, shifted++, width, out.row(y));
    }
  });
  return out;
}

ChannelPlane FilterColumns(const ChannelPlane& in, const Kernel& kernel,
                           int threads) {
  const int radius = Radius(kernel);
  ChannelPlane out(in.width(), in.height());
  ForRows(in.height(), threads, [&](int y) {
    int source = y - radius;
    for (const double weight : kernel) {
      const double* row = in.row(std::clamp(source++, 0, in.height() - 1));
      AddScaled(weight, row, in.width(), out.row(y));
    }
  });
  return out;
}

ChannelPlane Filter(const ChannelPlane& in, const Kernel& kernel, int threads) {
  return FilterColumns(FilterRows(in, kernel, threads), kernel, threads);
}

}  // namespace rtb
